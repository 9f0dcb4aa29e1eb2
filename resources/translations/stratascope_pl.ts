<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="pl">
    <context>
        <name>Core</name>
        <message>
            <source>Height gap</source>
            <translation>Przerwa wysokości</translation>
        </message>
        <message>
            <source>Heights of a cell that lie closer than this are one interval: raising it joins more, up to the robot's height nothing is lost for driving; below the vertical spacing of the scan lines walls shatter.</source>
            <translation>Wysokości w komórce bliższe niż ta wartość tworzą jeden przedział: większa wartość łączy ich więcej, do wysokości robota nic się nie traci dla jazdy; poniżej pionowego odstępu linii skanu ściany się rozpadają.</translation>
        </message>
        <message>
            <source>Outer radius</source>
            <translation>Promień zewnętrzny</translation>
        </message>
        <message>
            <source>Neighbours farther than this have no say in a normal: raising it steadies normals against range noise and rounds off edges and small parts.</source>
            <translation>Sąsiedzi dalsi niż ta wartość nie wpływają na normalną: większa wartość uspokaja normalne wobec szumu odległości i zaokrągla krawędzie oraz małe części.</translation>
        </message>
        <message>
            <source>Inner radius</source>
            <translation>Promień wewnętrzny</translation>
        </message>
        <message>
            <source>Neighbours nearer than this have no say in a normal: raising it keeps noisy short differences out; it must stay below the outer radius.</source>
            <translation>Sąsiedzi bliżsi niż ta wartość nie wpływają na normalną: większa wartość odrzuca zaszumione krótkie różnice; musi być mniejsza niż promień zewnętrzny.</translation>
        </message>
        <message>
            <source>Cell size</source>
            <translation>Rozmiar komórki</translation>
        </message>
        <message>
            <source>Edge of a map cell: raising it gives a coarser, smaller map with fewer empty cells.</source>
            <translation>Bok komórki mapy: większa wartość daje grubszą, mniejszą mapę z mniejszą liczbą pustych komórek.</translation>
        </message>
        <message>
            <source>Normal estimator</source>
            <translation>Estymator normalnych</translation>
        </message>
        <message>
            <source>closest</source>
            <translation>najbliżsi</translation>
        </message>
        <message>
            <source>adaptive</source>
            <translation>adaptacyjny</translation>
        </message>
        <message>
            <source>regression</source>
            <translation>regresja</translation>
        </message>
        <message>
            <source>How a normal is found: from adjacent beams (fast, very noisy), from the first neighbours inside the shell, or by least squares over all points of the shell.</source>
            <translation>Jak wyznacza się normalną: z sąsiednich wiązek (szybko, z dużym szumem), z pierwszych sąsiadów w powłoce albo metodą najmniejszych kwadratów ze wszystkich punktów powłoki.</translation>
        </message>
        <message>
            <source>Plane fit</source>
            <translation>Dopasowanie płaszczyzny</translation>
        </message>
        <message>
            <source>tls</source>
            <translation>tls</translation>
        </message>
        <message>
            <source>paper</source>
            <translation>artykuł</translation>
        </message>
        <message>
            <source>How a plane is fitted: total least squares, or the paper's regression, which cannot hold a plane through the sensor and says so.</source>
            <translation>Jak dopasowuje się płaszczyznę: całkowitą metodą najmniejszych kwadratów albo regresją z artykułu, która nie opisuje płaszczyzny przechodzącej przez czujnik i to mówi.</translation>
        </message>
        <message>
            <source>Interval rule</source>
            <translation>Reguła przedziałów</translation>
        </message>
        <message>
            <source>linked</source>
            <translation>łączona</translation>
        </message>
        <message>
            <source>How heights become intervals: linked by gaps below the height gap, whatever their order, or the paper's rule, point by point in the order of the scan.</source>
            <translation>Jak wysokości stają się przedziałami: łączone przerwami mniejszymi od przerwy wysokości, niezależnie od kolejności, albo regułą z artykułu, punkt po punkcie w kolejności skanu.</translation>
        </message>
        <message>
            <source>Angle tolerance</source>
            <translation>Tolerancja kąta</translation>
        </message>
        <message>
            <source>Normals closer than this count as parallel: raising it makes surfaces larger and edges thinner.</source>
            <translation>Normalne bliższe niż ten kąt uchodzą za równoległe: większa wartość powiększa powierzchnie i zwęża krawędzie.</translation>
        </message>
        <message>
            <source>Class tolerance</source>
            <translation>Tolerancja klasy</translation>
        </message>
        <message>
            <source>A normal this close to an axis is facing, side or horizontal: raising it leaves fewer surfaces oblique.</source>
            <translation>Normalna tak bliska osi jest czołowa, boczna lub pozioma: większa wartość pozostawia mniej powierzchni ukośnych.</translation>
        </message>
        <message>
            <source>Plane distance</source>
            <translation>Odległość od płaszczyzny</translation>
        </message>
        <message>
            <source>Points farther than this from a plane never belong to it: raising it makes planes swallow noise and shallow steps.</source>
            <translation>Punkty dalsze od płaszczyzny nigdy do niej nie należą: większa wartość sprawia, że płaszczyzny wchłaniają szum i płytkie stopnie.</translation>
        </message>
        <message>
            <source>Smallest plane</source>
            <translation>Najmniejsza płaszczyzna</translation>
        </message>
        <message>
            <source>Regions with fewer points than this are no planes: raising it leaves only the large ones.</source>
            <translation>Obszary o mniejszej liczbie punktów nie są płaszczyznami: większa wartość pozostawia tylko duże.</translation>
        </message>
        <message>
            <source>Align to walls</source>
            <translation>Wyrównaj do ścian</translation>
        </message>
        <message>
            <source>Measures classes against the building's dominant wall direction and not the sensor's: for scans taken askew.</source>
            <translation>Mierzy klasy względem głównego kierunku ścian budynku, a nie czujnika: dla skanów wykonanych na ukos.</translation>
        </message>
        <message>
            <source>Join pieces</source>
            <translation>Łącz części</translation>
        </message>
        <message>
            <source>Gives neighbouring pieces of one plane, split by something in front of it, one label.</source>
            <translation>Nadaje jedną etykietę sąsiednim częściom jednej płaszczyzny rozdzielonym przez coś przed nią.</translation>
        </message>
        <message>
            <source>Clean classes</source>
            <translation>Wygładź klasy</translation>
        </message>
        <message>
            <source>Lets the majority of the neighbours overrule single neurons of another class.</source>
            <translation>Pozwala większości sąsiadów przegłosować pojedyncze neurony innej klasy.</translation>
        </message>
        <message>
            <source>Nearest range</source>
            <translation>Najmniejsza odległość</translation>
        </message>
        <message>
            <source>Returns nearer than this are left out: raising it removes the robot itself; 0 is no limit.</source>
            <translation>Bliższe odbicia są pomijane: większa wartość usuwa samego robota; 0 to brak granicy.</translation>
        </message>
        <message>
            <source>Farthest range</source>
            <translation>Największa odległość</translation>
        </message>
        <message>
            <source>Returns farther than this are left out: raising it lets in more of the distance; 0 is no limit.</source>
            <translation>Dalsze odbicia są pomijane: większa wartość dopuszcza dalsze otoczenie; 0 to brak granicy.</translation>
        </message>
        <message>
            <source>Points</source>
            <translation>Punkty</translation>
        </message>
        <message>
            <source>Normals</source>
            <translation>Normalne</translation>
        </message>
        <message>
            <source>Classes</source>
            <translation>Klasy</translation>
        </message>
        <message>
            <source>Planes</source>
            <translation>Płaszczyzny</translation>
        </message>
        <message>
            <source>Edges</source>
            <translation>Krawędzie</translation>
        </message>
        <message>
            <source>Cells</source>
            <translation>Komórki</translation>
        </message>
        <message>
            <source>2.5D map</source>
            <translation>Mapa 2,5D</translation>
        </message>
        <message>
            <source>Extended 2.5D map</source>
            <translation>Rozszerzona mapa 2,5D</translation>
        </message>
        <message>
            <source>Raster-object map</source>
            <translation>Mapa rastrowo-obiektowa</translation>
        </message>
        <message>
            <source>Facing</source>
            <translation>Czołowa</translation>
        </message>
        <message>
            <source>Side</source>
            <translation>Boczna</translation>
        </message>
        <message>
            <source>Horizontal</source>
            <translation>Pozioma</translation>
        </message>
        <message>
            <source>Oblique</source>
            <translation>Ukośna</translation>
        </message>
        <message>
            <source>Convex edge</source>
            <translation>Krawędź wypukła</translation>
        </message>
        <message>
            <source>Concave edge</source>
            <translation>Krawędź wklęsła</translation>
        </message>
        <message>
            <source>Jump edge</source>
            <translation>Krawędź skokowa</translation>
        </message>
        <message>
            <source>Unknown</source>
            <translation>Nieznana</translation>
        </message>
        <message>
            <source>floor</source>
            <translation>podłoga</translation>
        </message>
        <message>
            <source>ceiling</source>
            <translation>sufit</translation>
        </message>
        <message>
            <source>raised</source>
            <translation>podwyższenie</translation>
        </message>
        <message>
            <source>As in the paper</source>
            <translation>Jak w artykule</translation>
        </message>
        <message>
            <source>Driving</source>
            <translation>Jazda</translation>
        </message>
        <message>
            <source>Fine detail</source>
            <translation>Drobne szczegóły</translation>
        </message>
        <message>
            <source>Large halls</source>
            <translation>Duże hale</translation>
        </message>
        <message>
            <source>Nearest neighbours</source>
            <translation>Najbliżsi sąsiedzi</translation>
        </message>
        <message>
            <source>Noisy scanner</source>
            <translation>Zaszumiony skaner</translation>
        </message>
        <message>
            <source>left</source>
            <translation>z lewej</translation>
        </message>
        <message>
            <source>right</source>
            <translation>z prawej</translation>
        </message>
        <message>
            <source>line before</source>
            <translation>linia przed</translation>
        </message>
        <message>
            <source>line after</source>
            <translation>linia po</translation>
        </message>
    </context>
    <context>
        <name>QObject</name>
        <message>
            <source>Surface class</source>
            <translation>Klasa powierzchni</translation>
        </message>
        <message>
            <source>Plane</source>
            <translation>Płaszczyzna</translation>
        </message>
        <message>
            <source>Direction</source>
            <translation>Kierunek</translation>
        </message>
        <message>
            <source>Height</source>
            <translation>Wysokość</translation>
        </message>
        <message>
            <source>Range</source>
            <translation>Odległość</translation>
        </message>
        <message>
            <source>σ of its plane</source>
            <translation>σ płaszczyzny</translation>
        </message>
        <message>
            <source>Angle of normals</source>
            <translation>Kąt normalnych</translation>
        </message>
        <message>
            <source>Number of records</source>
            <translation>Liczba rekordów</translation>
        </message>
        <message>
            <source>Clearance</source>
            <translation>Prześwit</translation>
        </message>
        <message>
            <source>Height in m</source>
            <translation>Wysokość w m</translation>
        </message>
        <message>
            <source>Range in m</source>
            <translation>Odległość w m</translation>
        </message>
        <message>
            <source>σ of its plane in mm</source>
            <translation>σ płaszczyzny w mm</translation>
        </message>
        <message>
            <source>Angle to neighbouring normals in °</source>
            <translation>Kąt do sąsiednich normalnych w °</translation>
        </message>
        <message>
            <source>Records in a cell</source>
            <translation>Rekordy w komórce</translation>
        </message>
        <message>
            <source>Free height above in m</source>
            <translation>Wolna wysokość powyżej w m</translation>
        </message>
        <message>
            <source>%1 %2 → %3</source>
            <translation>%1 %2 → %3</translation>
        </message>
        <message>
            <source>on</source>
            <translation>wł.</translation>
        </message>
        <message>
            <source>off</source>
            <translation>wył.</translation>
        </message>
        <message>
            <source>Class</source>
            <translation>Klasa</translation>
        </message>
        <message>
            <source>Points</source>
            <translation>Punkty</translation>
        </message>
        <message>
            <source>Neither a surface nor an edge could be told.</source>
            <translation>Nie dało się rozpoznać ani powierzchni, ani krawędzi.</translation>
        </message>
        <message>
            <source>No normal: too few neighbours inside the shell, and no edge beside it.</source>
            <translation>Bez normalnej: za mało sąsiadów w powłoce i brak krawędzi obok.</translation>
        </message>
        <message>
            <source>The depth breaks off beside it: what lies behind is hidden.</source>
            <translation>Głębia urywa się obok: to, co leży za nim, jest zasłonięte.</translation>
        </message>
        <message>
            <source>Normals beside it differ by more than %1 (here up to %2) and open: a convex edge.</source>
            <translation>Normalne obok różnią się o więcej niż %1 (tu do %2) i rozchylają się: krawędź wypukła.</translation>
        </message>
        <message>
            <source>Normals beside it differ by more than %1 (here up to %2) and close: a concave edge.</source>
            <translation>Normalne obok różnią się o więcej niż %1 (tu do %2) i zbiegają się: krawędź wklęsła.</translation>
        </message>
        <message>
            <source>The majority of its neighbours gave it their class.</source>
            <translation>Większość sąsiadów nadała mu swoją klasę.</translation>
        </message>
        <message>
            <source>Its own normal says %1; the majority of its neighbours overruled it.</source>
            <translation>Jego normalna mówi: %1; większość sąsiadów go przegłosowała.</translation>
        </message>
        <message>
            <source>Its normal is %1 from the viewing axis; %2 are allowed.</source>
            <translation>Jego normalna jest o %1 od osi patrzenia; dozwolone jest %2.</translation>
        </message>
        <message>
            <source>Its normal is %1 from the axis across the view; %2 are allowed.</source>
            <translation>Jego normalna jest o %1 od osi w poprzek widoku; dozwolone jest %2.</translation>
        </message>
        <message>
            <source>Its normal is %1 from the vertical; %2 are allowed.</source>
            <translation>Jego normalna jest o %1 od pionu; dozwolone jest %2.</translation>
        </message>
        <message>
            <source>Its normal is more than %1 from every axis; the nearest is %2 away.</source>
            <translation>Jego normalna jest dalej niż %1 od każdej osi; najbliższa jest o %2.</translation>
        </message>
        <message>
            <source>Defaults</source>
            <translation>Domyślne</translation>
        </message>
        <message>
            <source>%1: cannot be read</source>
            <translation>%1: nie można odczytać</translation>
        </message>
        <message>
            <source>none</source>
            <translation>brak</translation>
        </message>
        <message>
            <source>plane %1</source>
            <translation>płaszczyzna %1</translation>
        </message>
        <message>
            <source>Why</source>
            <translation>Dlaczego</translation>
        </message>
        <message>
            <source>Taken</source>
            <translation>Przyjęci</translation>
        </message>
        <message>
            <source>%1 from %2 to %3</source>
            <translation>%1 od %2 do %3</translation>
        </message>
        <message>
            <source>Refused</source>
            <translation>Odrzuceni</translation>
        </message>
        <message>
            <source>%1 too near</source>
            <translation>%1 za blisko</translation>
        </message>
        <message>
            <source>%1 too far</source>
            <translation>%1 za daleko</translation>
        </message>
        <message>
            <source>Off the normal</source>
            <translation>Odchylenie od normalnej</translation>
        </message>
        <message>
            <source>parallel</source>
            <translation>równoległa</translation>
        </message>
        <message>
            <source>not parallel</source>
            <translation>nierównoległa</translation>
        </message>
        <message>
            <source>no normal</source>
            <translation>bez normalnej</translation>
        </message>
        <message>
            <source>Neighbouring normals</source>
            <translation>Sąsiednie normalne</translation>
        </message>
        <message>
            <source>Point</source>
            <translation>Punkt</translation>
        </message>
        <message>
            <source>Scan</source>
            <translation>Skan</translation>
        </message>
        <message>
            <source>Number in file</source>
            <translation>Numer w pliku</translation>
        </message>
        <message>
            <source>Line</source>
            <translation>Linia</translation>
        </message>
        <message>
            <source>Beam</source>
            <translation>Wiązka</translation>
        </message>
        <message>
            <source>Neuron</source>
            <translation>Neuron</translation>
        </message>
        <message>
            <source>none: a nearer point has it</source>
            <translation>brak: ma go bliższy punkt</translation>
        </message>
        <message>
            <source>x, y, z in m</source>
            <translation>x, y, z w m</translation>
        </message>
        <message>
            <source>Normal</source>
            <translation>Normalna</translation>
        </message>
        <message>
            <source>Reach</source>
            <translation>Zasięg</translation>
        </message>
        <message>
            <source>Off the plane</source>
            <translation>Od płaszczyzny</translation>
        </message>
        <message>
            <source>Cell</source>
            <translation>Komórka</translation>
        </message>
        <message>
            <source>Cell k %1, l %2</source>
            <translation>Komórka k %1, l %2</translation>
        </message>
        <message>
            <source>Centre x, y</source>
            <translation>Środek x, y</translation>
        </message>
        <message>
            <source>2.5D height</source>
            <translation>Wysokość 2,5D</translation>
        </message>
        <message>
            <source>Records</source>
            <translation>Rekordy</translation>
        </message>
        <message>
            <source>points</source>
            <translation>punkty</translation>
        </message>
        <message>
            <source>planes</source>
            <translation>płaszczyzny</translation>
        </message>
        <message>
            <source>This plane is not found with the present parameters.</source>
            <translation>Tej płaszczyzny nie ma przy obecnych parametrach.</translation>
        </message>
        <message>
            <source>Plane %1</source>
            <translation>Płaszczyzna %1</translation>
        </message>
        <message>
            <source>Label</source>
            <translation>Etykieta</translation>
        </message>
        <message>
            <source>Role</source>
            <translation>Rola</translation>
        </message>
        <message>
            <source>Area</source>
            <translation>Pole</translation>
        </message>
        <message>
            <source>Offset</source>
            <translation>Przesunięcie</translation>
        </message>
        <message>
            <source>Equation</source>
            <translation>Równanie</translation>
        </message>
        <message>
            <source>Tilt</source>
            <translation>Nachylenie</translation>
        </message>
        <message>
            <source>σ (10)</source>
            <translation>σ (10)</translation>
        </message>
        <message>
            <source>rms</source>
            <translation>rms</translation>
        </message>
        <message>
            <source>Centroid</source>
            <translation>Środek ciężkości</translation>
        </message>
        <message>
            <source>Cells</source>
            <translation>Komórki</translation>
        </message>
        <message>
            <source>Format</source>
            <translation>Format</translation>
        </message>
        <message>
            <source>Lattice</source>
            <translation>Siatka</translation>
        </message>
        <message>
            <source>%1 lines × %2 beams</source>
            <translation>%1 linii × %2 wiązek</translation>
        </message>
        <message>
            <source>Missing returns</source>
            <translation>Brakujące odbicia</translation>
        </message>
        <message>
            <source>Points in the file</source>
            <translation>Punkty w pliku</translation>
        </message>
        <message>
            <source>Sensor at</source>
            <translation>Czujnik w</translation>
        </message>
        <message>
            <source>Range noise</source>
            <translation>Szum odległości</translation>
        </message>
        <message>
            <source>Planes</source>
            <translation>Płaszczyzny</translation>
        </message>
        <message>
            <source>install a graphics driver or Mesa's software renderer, or use stratascope-cli</source>
            <translation>zainstaluj sterownik grafiki lub programowy renderer Mesa albo użyj stratascope-cli</translation>
        </message>
        <message>
            <source>OpenGL cannot be used on this display; %1</source>
            <translation>Na tym ekranie nie można użyć OpenGL; %1</translation>
        </message>
        <message>
            <source>OpenGL 3.2 is needed, this display has %1.%2; %3</source>
            <translation>Potrzebny jest OpenGL 3.2, ten ekran ma %1.%2; %3</translation>
        </message>
        <message>
            <source>Scans (%1);;All files (*)</source>
            <translation>Skany (%1);;Wszystkie pliki (*)</translation>
        </message>
        <message>
            <source>distance %1</source>
            <translation>odległość %1</translation>
        </message>
        <message>
            <source>height %1</source>
            <translation>wysokość %1</translation>
        </message>
        <message>
            <source>along the ground %1</source>
            <translation>po podłożu %1</translation>
        </message>
        <message>
            <source>angle %1</source>
            <translation>kąt %1</translation>
        </message>
        <message>
            <source>%1 to %2 m: %3 points</source>
            <translation>%1 do %2 m: %3 punktów</translation>
        </message>
        <message>
            <source>gap of ε = %1 m or more</source>
            <translation>przerwa ε = %1 m lub większa</translation>
        </message>
        <message>
            <source>Points of cell k %1, l %2</source>
            <translation>Punkty komórki k %1, l %2</translation>
        </message>
        <message>
            <source>Points of all cells</source>
            <translation>Punkty wszystkich komórek</translation>
        </message>
        <message>
            <source>, per %1 m</source>
            <translation>, na %1 m</translation>
        </message>
        <message>
            <source>There is no point in this cell</source>
            <translation>W tej komórce nie ma punktów</translation>
        </message>
        <message>
            <source>There is no point</source>
            <translation>Nie ma punktów</translation>
        </message>
        <message>
            <source>%1 to %2°: %3 pairs</source>
            <translation>%1 do %2°: %3 par</translation>
        </message>
        <message>
            <source>Pairs of neighbours, per degree</source>
            <translation>Pary sąsiadów na stopień</translation>
        </message>
        <message>
            <source>Angle between their normals in °</source>
            <translation>Kąt między ich normalnymi w °</translation>
        </message>
        <message>
            <source>There is no pair of normals</source>
            <translation>Nie ma pary normalnych</translation>
        </message>
        <message>
            <source>plane %1: σ %2 mm, %3 points</source>
            <translation>płaszczyzna %1: σ %2 mm, %3 punktów</translation>
        </message>
        <message>
            <source>σ in mm</source>
            <translation>σ w mm</translation>
        </message>
        <message>
            <source>Number of the plane</source>
            <translation>Numer płaszczyzny</translation>
        </message>
        <message>
            <source>No plane was found</source>
            <translation>Nie znaleziono płaszczyzny</translation>
        </message>
        <message>
            <source>%1 per cell: %2 cells</source>
            <translation>%1 w komórce: %2 komórek</translation>
        </message>
        <message>
            <source>There is no record</source>
            <translation>Nie ma rekordów</translation>
        </message>
        <message>
            <source>%1 per record: %2 records</source>
            <translation>%1 w rekordzie: %2 rekordów</translation>
        </message>
        <message>
            <source>Points in a record</source>
            <translation>Punkty w rekordzie</translation>
        </message>
        <message>
            <source>Heights</source>
            <translation>Wysokości</translation>
        </message>
        <message>
            <source>Angles between normals</source>
            <translation>Kąty między normalnymi</translation>
        </message>
        <message>
            <source>σ by plane</source>
            <translation>σ płaszczyzn</translation>
        </message>
        <message>
            <source>Records per cell</source>
            <translation>Rekordy w komórce</translation>
        </message>
        <message>
            <source>Points per record</source>
            <translation>Punkty w rekordzie</translation>
        </message>
        <message>
            <source>%1: cannot be written; choose another folder</source>
            <translation>%1: nie można zapisać; wybierz inny folder</translation>
        </message>
        <message>
            <source>%1 (%2 points)</source>
            <translation>%1 (%2 punktów)</translation>
        </message>
        <message>
            <source> and %1 more</source>
            <translation> i %1 więcej</translation>
        </message>
        <message>
            <source>%1 planes kept, %2 lost, %3 gained.</source>
            <translation>Zachowane płaszczyzny: %1, utracone: %2, nowe: %3.</translation>
        </message>
        <message>
            <source>Lost: %1</source>
            <translation>Utracone: %1</translation>
        </message>
        <message>
            <source>Gained: %1</source>
            <translation>Nowe: %1</translation>
        </message>
        <message>
            <source>A and B have the same parameters. Change one: B follows, A stays.</source>
            <translation>A i B mają te same parametry. Zmień jeden: B podąży za nim, A zostanie.</translation>
        </message>
        <message>
            <source>Parameters that differ</source>
            <translation>Różniące się parametry</translation>
        </message>
        <message>
            <source>B − A</source>
            <translation>B − A</translation>
        </message>
        <message>
            <source>Numbers</source>
            <translation>Liczby</translation>
        </message>
        <message>
            <source>Edges</source>
            <translation>Krawędzie</translation>
        </message>
        <message>
            <source>Classified</source>
            <translation>Sklasyfikowane</translation>
        </message>
        <message>
            <source>On planes</source>
            <translation>Na płaszczyznach</translation>
        </message>
        <message>
            <source>Occupied cells</source>
            <translation>Zajęte komórki</translation>
        </message>
        <message>
            <source>Mean σ of planes</source>
            <translation>Średnie σ płaszczyzn</translation>
        </message>
        <message>
            <source>What became of the points</source>
            <translation>Co stało się z punktami</translation>
        </message>
        <message>
            <source>of another class, in all</source>
            <translation>innej klasy, razem</translation>
        </message>
        <message>
            <source>What became of the cells</source>
            <translation>Co stało się z komórkami</translation>
        </message>
        <message>
            <source>The cells of A are %1 wide, those of B %2: maps are compared by their numbers only.</source>
            <translation>Komórki A mają bok %1, komórki B %2: mapy porównano tylko liczbami.</translation>
        </message>
        <message>
            <source>Last time of each stage</source>
            <translation>Ostatni czas każdego etapu</translation>
        </message>
        <message>
            <source>Points, A → B</source>
            <translation>Punkty, A → B</translation>
        </message>
        <message>
            <source>Cells, A → B</source>
            <translation>Komórki, A → B</translation>
        </message>
        <message>
            <source>unchanged</source>
            <translation>bez zmian</translation>
        </message>
        <message>
            <source>new in B</source>
            <translation>nowe w B</translation>
        </message>
        <message>
            <source>only in A, not drawn</source>
            <translation>tylko w A, nierysowane</translation>
        </message>
        <message>
            <source>gained a plane</source>
            <translation>zyskały płaszczyznę</translation>
        </message>
        <message>
            <source>lost its plane</source>
            <translation>straciły płaszczyznę</translation>
        </message>
        <message>
            <source>another plane</source>
            <translation>inna płaszczyzna</translation>
        </message>
        <message>
            <source>another class only</source>
            <translation>tylko inna klasa</translation>
        </message>
        <message>
            <source>empty</source>
            <translation>puste</translation>
        </message>
        <message>
            <source>other heights</source>
            <translation>inne wysokości</translation>
        </message>
        <message>
            <source>more records</source>
            <translation>więcej rekordów</translation>
        </message>
        <message>
            <source>fewer records</source>
            <translation>mniej rekordów</translation>
        </message>
        <message>
            <source>only in A</source>
            <translation>tylko w A</translation>
        </message>
        <message>
            <source>Convex</source>
            <translation>Wypukła</translation>
        </message>
        <message>
            <source>Concave</source>
            <translation>Wklęsła</translation>
        </message>
        <message>
            <source>Jump</source>
            <translation>Skokowa</translation>
        </message>
        <message>
            <source>%1 edge</source>
            <translation>Krawędź: %1</translation>
        </message>
        <message>
            <source>Kind</source>
            <translation>Rodzaj</translation>
        </message>
        <message>
            <source>Vertical</source>
            <translation>Pion</translation>
        </message>
        <message>
            <source>yes</source>
            <translation>tak</translation>
        </message>
        <message>
            <source>no</source>
            <translation>nie</translation>
        </message>
        <message>
            <source>Length</source>
            <translation>Długość</translation>
        </message>
        <message>
            <source>Ends</source>
            <translation>Kończy</translation>
        </message>
        <message>
            <source>Joins</source>
            <translation>Łączy</translation>
        </message>
        <message>
            <source>Between normals</source>
            <translation>Między normalnymi</translation>
        </message>
        <message>
            <source>From</source>
            <translation>Od</translation>
        </message>
        <message>
            <source>To</source>
            <translation>Do</translation>
        </message>
        <message>
            <source>Classified in %</source>
            <translation>Sklasyfikowane w %</translation>
        </message>
        <message>
            <source>In planes in %</source>
            <translation>W płaszczyznach w %</translation>
        </message>
        <message>
            <source>Mean σ in mm</source>
            <translation>Średnia σ w mm</translation>
        </message>
        <message>
            <source>Time in ms</source>
            <translation>Czas w ms</translation>
        </message>
        <message>
            <source> in %1</source>
            <translation> w %1</translation>
        </message>
        <message>
            <source>Where a robot can drive</source>
            <translation>Gdzie może jechać robot</translation>
        </message>
        <message>
            <source>Robot %1 high, radius %2, steps %3</source>
            <translation>Robot o wysokości %1, promień %2, stopnie %3</translation>
        </message>
        <message>
            <source>cells free in both maps</source>
            <translation>komórki wolne na obu mapach</translation>
        </message>
        <message>
            <source>cells only the extended map frees</source>
            <translation>komórki wolne tylko na mapie rozszerzonej</translation>
        </message>
        <message>
            <source>cells blocked</source>
            <translation>komórki zablokowane</translation>
        </message>
    </context>
    <context>
        <name>stratascope::Actions</name>
        <message>
            <source>&amp;Help</source>
            <translation>Pomo&amp;c</translation>
        </message>
        <message>
            <source>&amp;Keys</source>
            <translation>&amp;Klawisze</translation>
        </message>
        <message>
            <source>&amp;About Stratascope</source>
            <translation>&amp;O programie Stratascope</translation>
        </message>
        <message>
            <source>&amp;File</source>
            <translation>&amp;Plik</translation>
        </message>
        <message>
            <source>&amp;Open…</source>
            <translation>&amp;Otwórz…</translation>
        </message>
        <message>
            <source>Open one scan, or several into one map</source>
            <translation>Otwórz jeden skan albo kilka w jednej mapie</translation>
        </message>
        <message>
            <source>Open &amp;recent</source>
            <translation>Otwórz &amp;niedawne</translation>
        </message>
        <message>
            <source>Re&amp;load</source>
            <translation>Wczytaj ponow&amp;nie</translation>
        </message>
        <message>
            <source>Read the files again</source>
            <translation>Wczytaj pliki jeszcze raz</translation>
        </message>
        <message>
            <source>&amp;Export…</source>
            <translation>&amp;Eksportuj…</translation>
        </message>
        <message>
            <source>Write cloud, planes, edges and both maps into a folder</source>
            <translation>Zapisz chmurę, płaszczyzny, krawędzie i obie mapy w folderze</translation>
        </message>
        <message>
            <source>&amp;Save picture…</source>
            <translation>&amp;Zapisz obraz…</translation>
        </message>
        <message>
            <source>Save a picture of the views</source>
            <translation>Zapisz obraz widoków</translation>
        </message>
        <message>
            <source>&amp;Quit</source>
            <translation>Za&amp;kończ</translation>
        </message>
        <message>
            <source>&amp;Edit</source>
            <translation>&amp;Edycja</translation>
        </message>
        <message>
            <source>&amp;Undo</source>
            <translation>&amp;Cofnij</translation>
        </message>
        <message>
            <source>&amp;Redo</source>
            <translation>&amp;Ponów</translation>
        </message>
        <message>
            <source>Reset all &amp;parameters</source>
            <translation>Przywróć wszystkie &amp;parametry</translation>
        </message>
        <message>
            <source>&amp;Load parameters…</source>
            <translation>&amp;Wczytaj parametry…</translation>
        </message>
        <message>
            <source>&amp;Save parameters…</source>
            <translation>&amp;Zapisz parametry…</translation>
        </message>
        <message>
            <source>&amp;Copy as command line</source>
            <translation>&amp;Kopiuj jako wiersz poleceń</translation>
        </message>
        <message>
            <source>Clear selectio&amp;n</source>
            <translation>Wyczyść zaz&amp;naczenie</translation>
        </message>
        <message>
            <source>&amp;View</source>
            <translation>&amp;Widok</translation>
        </message>
        <message>
            <source>&amp;Reset</source>
            <translation>&amp;Resetuj</translation>
        </message>
        <message>
            <source>Fit the data into all views</source>
            <translation>Dopasuj dane do wszystkich widoków</translation>
        </message>
        <message>
            <source>&amp;Oblique</source>
            <translation>&amp;Ukośnie</translation>
        </message>
        <message>
            <source>From behind the sensor, from above</source>
            <translation>Zza czujnika, z góry</translation>
        </message>
        <message>
            <source>&amp;Top</source>
            <translation>&amp;Z góry</translation>
        </message>
        <message>
            <source>From above</source>
            <translation>Z góry</translation>
        </message>
        <message>
            <source>&amp;Front</source>
            <translation>Z &amp;przodu</translation>
        </message>
        <message>
            <source>As the sensor looks</source>
            <translation>Tak, jak patrzy czujnik</translation>
        </message>
        <message>
            <source>&amp;Side</source>
            <translation>Z &amp;boku</translation>
        </message>
        <message>
            <source>From the right</source>
            <translation>Z prawej strony</translation>
        </message>
        <message>
            <source>&amp;Link cameras</source>
            <translation>Połącz &amp;kamery</translation>
        </message>
        <message>
            <source>Turn all three views together</source>
            <translation>Obracaj wszystkie trzy widoki razem</translation>
        </message>
        <message>
            <source>O&amp;rthographic</source>
            <translation>Rzut p&amp;rostokątny</translation>
        </message>
        <message>
            <source>Without perspective: lengths can be compared</source>
            <translation>Bez perspektywy: można porównywać długości</translation>
        </message>
        <message>
            <source>&amp;Fit</source>
            <translation>&amp;Dopasuj</translation>
        </message>
        <message>
            <source>Turn about the selection</source>
            <translation>Obracaj wokół zaznaczenia</translation>
        </message>
        <message>
            <source>&amp;Ground grid</source>
            <translation>&amp;Siatka podłoża</translation>
        </message>
        <message>
            <source>&amp;Plane outlines</source>
            <translation>&amp;Obrysy płaszczyzn</translation>
        </message>
        <message>
            <source>&amp;Edges</source>
            <translation>&amp;Krawędzie</translation>
        </message>
        <message>
            <source>None</source>
            <translation>Brak</translation>
        </message>
        <message>
            <source>Vertical ones</source>
            <translation>Pionowe</translation>
        </message>
        <message>
            <source>All, by kind</source>
            <translation>Wszystkie, według rodzaju</translation>
        </message>
        <message>
            <source>&amp;Colours</source>
            <translation>&amp;Kolory</translation>
        </message>
        <message>
            <source>Of the maps</source>
            <translation>Map</translation>
        </message>
        <message>
            <source>Viridis</source>
            <translation>Viridis</translation>
        </message>
        <message>
            <source>Cividis</source>
            <translation>Cividis</translation>
        </message>
        <message>
            <source>Lock ranges</source>
            <translation>Zablokuj zakresy</translation>
        </message>
        <message>
            <source>Keep the ranges of both scalar bars whatever the data says</source>
            <translation>Zachowaj zakresy obu skal barw bez względu na dane</translation>
        </message>
        <message>
            <source>&amp;Appearance</source>
            <translation>&amp;Wygląd</translation>
        </message>
        <message>
            <source>As the desktop</source>
            <translation>Jak pulpit</translation>
        </message>
        <message>
            <source>Light</source>
            <translation>Jasny</translation>
        </message>
        <message>
            <source>Dark</source>
            <translation>Ciemny</translation>
        </message>
        <message>
            <source>Reset la&amp;yout</source>
            <translation>Przywróć &amp;układ</translation>
        </message>
        <message>
            <source>All docks back to their places</source>
            <translation>Wszystkie panele z powrotem na miejsca</translation>
        </message>
        <message>
            <source>F&amp;ull screen</source>
            <translation>Pełny &amp;ekran</translation>
        </message>
        <message>
            <source>Tools</source>
            <translation>Narzędzia</translation>
        </message>
        <message>
            <source>&amp;Measure from the selection</source>
            <translation>&amp;Mierz od zaznaczenia</translation>
        </message>
        <message>
            <source>Open s&amp;tream…</source>
            <translation>Otwórz s&amp;trumień…</translation>
        </message>
        <message>
            <source>A scan that comes in line by line: from a scanner, or played</source>
            <translation>Skan, który nadchodzi linia po linii: ze skanera albo odtwarzany</translation>
        </message>
        <message>
            <source>Units and a&amp;xes…</source>
            <translation>Jednostki i &amp;osie…</translation>
        </message>
        <message>
            <source>How the files' coordinates are read</source>
            <translation>Jak odczytywane są współrzędne plików</translation>
        </message>
        <message>
            <source>Open s&amp;ession…</source>
            <translation>Otwórz s&amp;esję…</translation>
        </message>
        <message>
            <source>Scans, parameters and view as they were saved</source>
            <translation>Skany, parametry i widok, jak je zapisano</translation>
        </message>
        <message>
            <source>Save sess&amp;ion…</source>
            <translation>Zapisz ses&amp;ję…</translation>
        </message>
        <message>
            <source>Save scans, parameters and view, to go on later</source>
            <translation>Zapisz skany, parametry i widok, aby wrócić do nich później</translation>
        </message>
        <message>
            <source>Save picture with si&amp;ze…</source>
            <translation>Zapisz obraz o &amp;rozmiarze…</translation>
        </message>
        <message>
            <source>The views with as many pixels as you say</source>
            <translation>Widoki o podanej liczbie pikseli</translation>
        </message>
    </context>
    <context>
        <name>stratascope::Batch</name>
        <message>
            <source>%1: cannot be made; choose another folder</source>
            <translation>%1: nie można utworzyć; wybierz inny folder</translation>
        </message>
        <message>
            <source>%1: cannot be written; choose another folder</source>
            <translation>%1: nie można zapisać; wybierz inny folder</translation>
        </message>
    </context>
    <context>
        <name>stratascope::ChartPanel</name>
        <message>
            <source>Chart</source>
            <translation>Wykres</translation>
        </message>
        <message>
            <source>Logarithmic</source>
            <translation>Logarytmicznie</translation>
        </message>
        <message>
            <source>Counts by their logarithm, so that small ones are seen beside large ones</source>
            <translation>Liczności w skali logarytmicznej, aby małe było widać obok dużych</translation>
        </message>
        <message>
            <source>Write the chart to a file</source>
            <translation>Zapisz wykres do pliku</translation>
        </message>
        <message>
            <source>Write as CSV…</source>
            <translation>Zapisz jako CSV…</translation>
        </message>
        <message>
            <source>Save picture…</source>
            <translation>Zapisz obraz…</translation>
        </message>
        <message>
            <source>PNG (*.png)</source>
            <translation>PNG (*.png)</translation>
        </message>
        <message>
            <source>CSV (*.csv)</source>
            <translation>CSV (*.csv)</translation>
        </message>
        <message>
            <source>Wrote %1</source>
            <translation>Zapisano %1</translation>
        </message>
    </context>
    <context>
        <name>stratascope::ClassMatrix</name>
        <message>
            <source>Points by class: rows A, columns B</source>
            <translation>Punkty według klas: wiersze A, kolumny B</translation>
        </message>
        <message>
            <source>%1 in A, %2 in B: %3 points</source>
            <translation>%1 w A, %2 w B: %3 punktów</translation>
        </message>
    </context>
    <context>
        <name>stratascope::ClassOptions</name>
        <message>
            <source>Clean classes</source>
            <translation>Oczyszczanie klas</translation>
        </message>
        <message>
            <source>Stray surface classes follow their neighbours, by the majority template</source>
            <translation>Odosobnione klasy powierzchni podążają za sąsiadami, według szablonu większości</translation>
        </message>
        <message>
            <source>Axes of the building</source>
            <translation>Osie budynku</translation>
        </message>
        <message>
            <source>Facing and side are told by the main direction of the walls, not by where the sensor looks</source>
            <translation>Przód i bok określa główny kierunek ścian, a nie kierunek patrzenia czujnika</translation>
        </message>
        <message>
            <source>Do not clean classes</source>
            <translation>Bez oczyszczania klas</translation>
        </message>
        <message>
            <source>Axes of the sensor</source>
            <translation>Osie czujnika</translation>
        </message>
        <message>
            <source>would change: %1</source>
            <translation>zmieniłoby: %1</translation>
        </message>
        <message>
            <source>turned %1</source>
            <translation>obrót %1</translation>
        </message>
        <message>
            <source>How far the walls are turned against where the sensor looks</source>
            <translation>O ile ściany są obrócone względem kierunku patrzenia czujnika</translation>
        </message>
        <message>
            <source>%1 changed</source>
            <translation>zmieniono: %1</translation>
        </message>
    </context>
    <context>
        <name>stratascope::ClipControl</name>
        <message>
            <source>C&amp;lip</source>
            <translation>&amp;Wycinek</translation>
        </message>
        <message>
            <source>Clip &amp;box</source>
            <translation>&amp;Pudło</translation>
        </message>
        <message>
            <source>Show only what lies in a box; its handles are in the cloud (B)</source>
            <translation>Pokaż tylko to, co leży w pudle; uchwyty są w chmurze (B)</translation>
        </message>
        <message>
            <source>&amp;Around the selection</source>
            <translation>Wokół &amp;zaznaczenia</translation>
        </message>
        <message>
            <source>Around &amp;everything</source>
            <translation>Wokół &amp;wszystkiego</translation>
        </message>
    </context>
    <context>
        <name>stratascope::CloudPair</name>
        <message>
            <source>Point cloud</source>
            <translation>Chmura punktów</translation>
        </message>
        <message>
            <source>B · now</source>
            <translation>B · teraz</translation>
        </message>
        <message>
            <source>A · kept</source>
            <translation>A · zachowane</translation>
        </message>
    </context>
    <context>
        <name>stratascope::CloudView</name>
        <message>
            <source>Point cloud</source>
            <translation>Chmura punktów</translation>
        </message>
        <message>
            <source>What the colours of the points mean</source>
            <translation>Co oznaczają kolory punktów</translation>
        </message>
        <message>
            <source>%1 points</source>
            <translation>punkty: %1</translation>
        </message>
        <message>
            <source>%1 scans</source>
            <translation>skany: %1</translation>
        </message>
        <message>
            <source>%1 lines × %2 beams</source>
            <translation>%1 linii × %2 wiązek</translation>
        </message>
        <message>
            <source>below %1</source>
            <translation>poniżej %1</translation>
        </message>
        <message>
            <source>&lt; 1 %</source>
            <translation>&lt; 1 %</translation>
        </message>
        <message>
            <source>%1 %</source>
            <translation>%1 %</translation>
        </message>
        <message>
            <source>Surface class</source>
            <translation>Klasa powierzchni</translation>
        </message>
        <message>
            <source>%1 planes, a colour each</source>
            <translation>Płaszczyzny: %1, każda w swoim kolorze</translation>
        </message>
        <message>
            <source>no plane</source>
            <translation>bez płaszczyzny</translation>
        </message>
        <message>
            <source>no normal</source>
            <translation>bez normalnej</translation>
        </message>
        <message>
            <source>Direction of the normal</source>
            <translation>Kierunek normalnej</translation>
        </message>
        <message>
            <source>range %1</source>
            <translation>odległość %1</translation>
        </message>
        <message>
            <source>line %1, beam %2</source>
            <translation>linia %1, wiązka %2</translation>
        </message>
        <message>
            <source>plane %1</source>
            <translation>płaszczyzna %1</translation>
        </message>
        <message>
            <source>inside the clip box</source>
            <translation>wewnątrz pudła</translation>
        </message>
        <message>
            <source>%1 planes hidden</source>
            <translation>ukryte płaszczyzny: %1</translation>
        </message>
    </context>
    <context>
        <name>stratascope::ColumnView</name>
        <message>
            <source>points</source>
            <translation>punkty</translation>
        </message>
        <message>
            <source>2.5D</source>
            <translation>2,5D</translation>
        </message>
        <message>
            <source>extended</source>
            <translation>rozszerzona</translation>
        </message>
    </context>
    <context>
        <name>stratascope::CompareControl</name>
        <message>
            <source>&amp;Compare</source>
            <translation>P&amp;orównanie</translation>
        </message>
        <message>
            <source>&amp;Keep as A</source>
            <translation>&amp;Zachowaj jako A</translation>
        </message>
        <message>
            <source>Keep the present result as A and go on tuning as B (%1)</source>
            <translation>Zachowaj obecny wynik jako A i strój dalej jako B (%1)</translation>
        </message>
        <message>
            <source>&amp;Back to A</source>
            <translation>&amp;Wróć do A</translation>
        </message>
        <message>
            <source>&amp;Swap A and B</source>
            <translation>Za&amp;mień A i B</translation>
        </message>
        <message>
            <source>&amp;Drop A</source>
            <translation>&amp;Odrzuć A</translation>
        </message>
        <message>
            <source>A was a result of other scans and is dropped</source>
            <translation>A było wynikiem innych skanów i zostało odrzucone</translation>
        </message>
        <message>
            <source>Kept as A. What you change from now on is B.</source>
            <translation>Zachowano jako A. Od teraz zmieniasz B.</translation>
        </message>
        <message>
            <source>Back to A</source>
            <translation>Powrót do A</translation>
        </message>
        <message>
            <source>Swap A and B</source>
            <translation>Zamiana A i B</translation>
        </message>
    </context>
    <context>
        <name>stratascope::ComparePanel</name>
        <message>
            <source>What the views show of A and B</source>
            <translation>Co widoki pokazują z A i B</translation>
        </message>
        <message>
            <source>Keep the present result as A</source>
            <translation>Zachowaj obecny wynik jako A</translation>
        </message>
        <message>
            <source>Back to the parameters of A</source>
            <translation>Wróć do parametrów A</translation>
        </message>
        <message>
            <source>A becomes B and B becomes A</source>
            <translation>A staje się B, a B staje się A</translation>
        </message>
        <message>
            <source>Copy as text</source>
            <translation>Kopiuj jako tekst</translation>
        </message>
        <message>
            <source>Copied the comparison</source>
            <translation>Skopiowano porównanie</translation>
        </message>
        <message>
            <source>Drop A</source>
            <translation>Odrzuć A</translation>
        </message>
        <message>
            <source>Keep the present result as A and go on tuning: this page tells what changed.</source>
            <translation>Zachowaj obecny wynik jako A i strój dalej: ta strona powie, co się zmieniło.</translation>
        </message>
    </context>
    <context>
        <name>stratascope::Comparer</name>
        <message>
            <source>A and B could not be compared: %1</source>
            <translation>Nie udało się porównać A i B: %1</translation>
        </message>
        <message>
            <source>B only</source>
            <translation>Tylko B</translation>
        </message>
        <message>
            <source>A beside B</source>
            <translation>A obok B</translation>
        </message>
        <message>
            <source>Wipe</source>
            <translation>Kurtyna</translation>
        </message>
        <message>
            <source>Differences</source>
            <translation>Różnice</translation>
        </message>
    </context>
    <context>
        <name>stratascope::CutControl</name>
        <message>
            <source>Hide everything above this height in all three views. Results and exports keep it.</source>
            <translation>Ukryj wszystko powyżej tej wysokości we wszystkich trzech widokach. Wyniki i eksport to zachowują.</translation>
        </message>
        <message>
            <source>Cut above</source>
            <translation>Utnij powyżej</translation>
        </message>
        <message>
            <source> m</source>
            <translation> m</translation>
        </message>
        <message>
            <source>Auto</source>
            <translation>Auto</translation>
        </message>
        <message>
            <source>Cut just below the ceiling, if there is one</source>
            <translation>Utnij tuż pod sufitem, jeśli jest</translation>
        </message>
    </context>
    <context>
        <name>stratascope::EdgePanel</name>
        <message>
            <source>Filter by kind, vertical or plane</source>
            <translation>Filtruj: rodzaj, pionowa, płaszczyzna</translation>
        </message>
        <message>
            <source>#</source>
            <translation>#</translation>
        </message>
        <message>
            <source>Kind</source>
            <translation>Rodzaj</translation>
        </message>
        <message>
            <source>Joins</source>
            <translation>Łączy</translation>
        </message>
        <message>
            <source>Numbers of the planes that meet in it, or end at it</source>
            <translation>Numery płaszczyzn, które się w niej stykają lub na niej kończą</translation>
        </message>
        <message>
            <source>m</source>
            <translation>m</translation>
        </message>
        <message>
            <source>Length</source>
            <translation>Długość</translation>
        </message>
        <message>
            <source>Vert.</source>
            <translation>Pion</translation>
        </message>
        <message>
            <source>Within 15° of the vertical</source>
            <translation>Do 15° od pionu</translation>
        </message>
        <message>
            <source>Points</source>
            <translation>Punkty</translation>
        </message>
        <message>
            <source>σ mm</source>
            <translation>σ mm</translation>
        </message>
        <message>
            <source>Mean distance of its points from the line</source>
            <translation>Średnia odległość jej punktów od prostej</translation>
        </message>
        <message>
            <source>vertical</source>
            <translation>pionowa</translation>
        </message>
        <message>
            <source>From %1 to %2 m, %3 out of the vertical</source>
            <translation>Od %1 do %2 m, %3 od pionu</translation>
        </message>
        <message>
            <source>Show from near</source>
            <translation>Pokaż z bliska</translation>
        </message>
        <message>
            <source>Select plane %1</source>
            <translation>Zaznacz płaszczyznę %1</translation>
        </message>
        <message>
            <source>Copy this row</source>
            <translation>Kopiuj ten wiersz</translation>
        </message>
        <message>
            <source>Write edges</source>
            <translation>Zapis krawędzi</translation>
        </message>
    </context>
    <context>
        <name>stratascope::FlatMap</name>
        <message>
            <source>Height in m</source>
            <translation>Wysokość w m</translation>
        </message>
        <message>
            <source>Records a cell</source>
            <translation>Rekordy w komórce</translation>
        </message>
        <message>
            <source>x %1, y %2</source>
            <translation>x %1, y %2</translation>
        </message>
        <message>
            <source>height %1</source>
            <translation>wysokość %1</translation>
        </message>
        <message>
            <source>%1 records</source>
            <translation>rekordy: %1</translation>
        </message>
    </context>
    <context>
        <name>stratascope::FlatWindow</name>
        <message>
            <source>Not the same as when the session was saved: %1</source>
            <translation>Inne niż w chwili zapisania sesji: %1</translation>
        </message>
        <message>
            <source>Stratascope</source>
            <translation>Stratascope</translation>
        </message>
        <message>
            <source>The three views cannot be drawn: %1. Both maps are shown from above; everything else is computed and exported as usual.</source>
            <translation>Nie można narysować trzech widoków: %1. Obie mapy pokazano z góry; wszystko inne jest liczone i eksportowane jak zwykle.</translation>
        </message>
        <message>
            <source>2.5D map</source>
            <translation>Mapa 2.5D</translation>
        </message>
        <message>
            <source>Extended 2.5D map</source>
            <translation>Rozszerzona mapa 2.5D</translation>
        </message>
        <message>
            <source>Parameters</source>
            <translation>Parametry</translation>
        </message>
        <message>
            <source>&amp;File</source>
            <translation>&amp;Plik</translation>
        </message>
        <message>
            <source>&amp;Open…</source>
            <translation>&amp;Otwórz…</translation>
        </message>
        <message>
            <source>Open scans</source>
            <translation>Otwórz skany</translation>
        </message>
        <message>
            <source>&amp;Export…</source>
            <translation>&amp;Eksportuj…</translation>
        </message>
        <message>
            <source>&amp;Quit</source>
            <translation>&amp;Zakończ</translation>
        </message>
        <message>
            <source>Export maps, planes and cloud into a folder</source>
            <translation>Eksportuj mapy, płaszczyzny i chmurę do folderu</translation>
        </message>
        <message>
            <source>Exported to %1</source>
            <translation>Wyeksportowano do %1</translation>
        </message>
    </context>
    <context>
        <name>stratascope::FramePanel</name>
        <message>
            <source>metres</source>
            <translation>metry</translation>
        </message>
        <message>
            <source>centimetres</source>
            <translation>centymetry</translation>
        </message>
        <message>
            <source>millimetres</source>
            <translation>milimetry</translation>
        </message>
        <message>
            <source>feet</source>
            <translation>stopy</translation>
        </message>
        <message>
            <source>US survey feet</source>
            <translation>stopy geodezyjne USA</translation>
        </message>
        <message>
            <source>automatic</source>
            <translation>automatycznie</translation>
        </message>
        <message>
            <source>z up, x forward, y left</source>
            <translation>z w górę, x w przód, y w lewo</translation>
        </message>
        <message>
            <source>y up, x right, z backward</source>
            <translation>y w górę, x w prawo, z w tył</translation>
        </message>
        <message>
            <source>y up, x right, z forward (left-handed)</source>
            <translation>y w górę, x w prawo, z w przód (lewoskrętny)</translation>
        </message>
        <message>
            <source>y down, x right, z forward (camera)</source>
            <translation>y w dół, x w prawo, z w przód (kamera)</translation>
        </message>
        <message>
            <source>z down, x forward, y right</source>
            <translation>z w dół, x w przód, y w prawo</translation>
        </message>
        <message>
            <source>Give the sensor's pose</source>
            <translation>Podaj położenie czujnika</translation>
        </message>
        <message>
            <source>The points are in the sensor's own frame, and are moved by this pose into the map</source>
            <translation>Punkty są w układzie czujnika i to położenie przenosi je do mapy</translation>
        </message>
        <message>
            <source>x</source>
            <translation>x</translation>
        </message>
        <message>
            <source>y</source>
            <translation>y</translation>
        </message>
        <message>
            <source>z</source>
            <translation>z</translation>
        </message>
        <message>
            <source>Roll</source>
            <translation>Przechył</translation>
        </message>
        <message>
            <source>Pitch</source>
            <translation>Pochylenie</translation>
        </message>
        <message>
            <source>Yaw</source>
            <translation>Odchylenie</translation>
        </message>
        <message>
            <source> m</source>
            <translation> m</translation>
        </message>
        <message>
            <source>°</source>
            <translation>°</translation>
        </message>
        <message>
            <source>Back to the guess</source>
            <translation>Wróć do odgadniętych</translation>
        </message>
        <message>
            <source>Unit, axes and pose as the file says, or as they are guessed from its points</source>
            <translation>Jednostka, osie i położenie według pliku albo odgadnięte z jego punktów</translation>
        </message>
        <message>
            <source>Open a scan first.</source>
            <translation>Najpierw otwórz skan.</translation>
        </message>
        <message>
            <source>File</source>
            <translation>Plik</translation>
        </message>
        <message>
            <source>Unit</source>
            <translation>Jednostka</translation>
        </message>
        <message>
            <source>Axes</source>
            <translation>Osie</translation>
        </message>
        <message>
            <source>Size</source>
            <translation>Rozmiar</translation>
        </message>
        <message>
            <source>automatic: %1</source>
            <translation>automatycznie: %1</translation>
        </message>
        <message>
            <source>The file holds %1 scans with poses of their own.</source>
            <translation>Plik zawiera skany (%1) z własnymi położeniami.</translation>
        </message>
        <message>
            <source>Nothing had to be guessed.</source>
            <translation>Niczego nie trzeba było zgadywać.</translation>
        </message>
    </context>
    <context>
        <name>stratascope::HelpPanel</name>
        <message>
            <source>Keys</source>
            <translation>Klawisze</translation>
        </message>
        <message>
            <source>Search the help</source>
            <translation>Szukaj w pomocy</translation>
        </message>
        <message>
            <source>Left drag</source>
            <translation>Przeciąganie lewym</translation>
        </message>
        <message>
            <source>Turn</source>
            <translation>Obrót</translation>
        </message>
        <message>
            <source>Shift + left drag, middle drag</source>
            <translation>Shift + przeciąganie lewym, przeciąganie środkowym</translation>
        </message>
        <message>
            <source>Move</source>
            <translation>Przesunięcie</translation>
        </message>
        <message>
            <source>Wheel, right drag</source>
            <translation>Kółko, przeciąganie prawym</translation>
        </message>
        <message>
            <source>Nearer and farther</source>
            <translation>Bliżej i dalej</translation>
        </message>
        <message>
            <source>Click</source>
            <translation>Kliknięcie</translation>
        </message>
        <message>
            <source>Select in all views</source>
            <translation>Zaznaczenie we wszystkich widokach</translation>
        </message>
        <message>
            <source>Double click on a view's title</source>
            <translation>Podwójne kliknięcie tytułu widoku</translation>
        </message>
        <message>
            <source>Enlarge it, and back</source>
            <translation>Powiększenie i powrót</translation>
        </message>
        <message>
            <source>No page has all of these words.</source>
            <translation>Żadna strona nie zawiera wszystkich tych słów.</translation>
        </message>
    </context>
    <context>
        <name>stratascope::LineTrack</name>
        <message>
            <source>Lines of the scan</source>
            <translation>Linie skanu</translation>
        </message>
    </context>
    <context>
        <name>stratascope::LiveControl</name>
        <message>
            <source>Stream</source>
            <translation>Strumień</translation>
        </message>
        <message>
            <source>&amp;Stream</source>
            <translation>S&amp;trumień</translation>
        </message>
        <message>
            <source>&amp;Play or pause</source>
            <translation>&amp;Odtwarzaj lub wstrzymaj</translation>
        </message>
        <message>
            <source>One line &amp;on</source>
            <translation>Linię &amp;dalej</translation>
        </message>
        <message>
            <source>One line &amp;back</source>
            <translation>Linię &amp;wstecz</translation>
        </message>
        <message>
            <source>25 lines on</source>
            <translation>25 linii dalej</translation>
        </message>
        <message>
            <source>25 lines back</source>
            <translation>25 linii wstecz</translation>
        </message>
        <message>
            <source>&amp;Stop</source>
            <translation>&amp;Zatrzymaj</translation>
        </message>
    </context>
    <context>
        <name>stratascope::MainWindow</name>
        <message>
            <source>Computed %1 in %2: %3 planes, %4 records</source>
            <translation>Obliczono %1 w %2: płaszczyzny %3, rekordy %4</translation>
        </message>
        <message>
            <source>Click to inspect  ·  drag to turn  ·  wheel to zoom  ·  Shift-drag to move</source>
            <translation>Kliknij, aby zbadać  ·  przeciągnij, aby obrócić  ·  kółko: przybliżenie  ·  Shift i przeciągnij: przesunięcie</translation>
        </message>
        <message>
            <source>Stratascope</source>
            <translation>Stratascope</translation>
        </message>
        <message>
            <source>Stages</source>
            <translation>Etapy</translation>
        </message>
        <message>
            <source>Log</source>
            <translation>Dziennik</translation>
        </message>
        <message>
            <source>Help</source>
            <translation>Pomoc</translation>
        </message>
        <message>
            <source>Parameters</source>
            <translation>Parametry</translation>
        </message>
        <message>
            <source>Inspector</source>
            <translation>Inspektor</translation>
        </message>
        <message>
            <source>Planes</source>
            <translation>Płaszczyzny</translation>
        </message>
        <message>
            <source>Preset %1</source>
            <translation>Zestaw %1</translation>
        </message>
        <message>
            <source>%1 — Stratascope</source>
            <translation>%1 — Stratascope</translation>
        </message>
        <message>
            <source>%1 and %2 more</source>
            <translation>%1 i jeszcze %2</translation>
        </message>
        <message>
            <source>Reading</source>
            <translation>Wczytywanie</translation>
        </message>
        <message>
            <source>Open scans</source>
            <translation>Otwórz skany</translation>
        </message>
        <message>
            <source>Export maps, planes and cloud into a folder</source>
            <translation>Eksportuj mapy, płaszczyzny i chmurę do folderu</translation>
        </message>
        <message>
            <source>Exporting to %1 …</source>
            <translation>Eksport do %1 …</translation>
        </message>
        <message>
            <source>Exported to %1</source>
            <translation>Wyeksportowano do %1</translation>
        </message>
        <message>
            <source>Save picture of the views</source>
            <translation>Zapisz obraz widoków</translation>
        </message>
        <message>
            <source>PNG (*.png)</source>
            <translation>PNG (*.png)</translation>
        </message>
        <message>
            <source>Saved %1</source>
            <translation>Zapisano %1</translation>
        </message>
        <message>
            <source>%1: cannot be written; choose another folder</source>
            <translation>%1: nie można zapisać; wybierz inny folder</translation>
        </message>
        <message>
            <source>Load parameters</source>
            <translation>Wczytaj parametry</translation>
        </message>
        <message>
            <source>Parameters (*.json);;All files (*)</source>
            <translation>Parametry (*.json);;Wszystkie pliki (*)</translation>
        </message>
        <message>
            <source>Parameters of %1</source>
            <translation>Parametry z %1</translation>
        </message>
        <message>
            <source>Save parameters</source>
            <translation>Zapisz parametry</translation>
        </message>
        <message>
            <source>Parameters (*.json)</source>
            <translation>Parametry (*.json)</translation>
        </message>
        <message>
            <source>Hidden scans, and units, axes or poses of some of the files only, are more than options can say; save a session and run stratascope-cli process --session</source>
            <translation>Ukryte skany oraz jednostki, osie lub pozy tylko niektórych plików nie dadzą się wyrazić opcjami; zapisz sesję i uruchom stratascope-cli process --session</translation>
        </message>
        <message>
            <source>Copied: %1</source>
            <translation>Skopiowano: %1</translation>
        </message>
        <message>
            <source>About Stratascope</source>
            <translation>O programie Stratascope</translation>
        </message>
        <message>
            <source>&lt;h3&gt;Stratascope %1&lt;/h3&gt;&lt;p&gt;2.5D and extended 2.5D maps from scans of a rotating laser scanner, through a cellular neural network.&lt;/p&gt;&lt;p&gt;BSD-3-Clause&lt;/p&gt;</source>
            <translation>&lt;h3&gt;Stratascope %1&lt;/h3&gt;&lt;p&gt;Mapy 2,5D i rozszerzone mapy 2,5D ze skanów obracanego skanera laserowego, przez komórkową sieć neuronową.&lt;/p&gt;&lt;p&gt;BSD-3-Clause&lt;/p&gt;</translation>
        </message>
        <message>
            <source>Select a point or a plane, then another one</source>
            <translation>Zaznacz punkt lub płaszczyznę, a potem następną</translation>
        </message>
        <message>
            <source>Edges</source>
            <translation>Krawędzie</translation>
        </message>
        <message>
            <source>Compare</source>
            <translation>Porównanie</translation>
        </message>
        <message>
            <source>Charts</source>
            <translation>Wykresy</translation>
        </message>
        <message>
            <source>Sweep</source>
            <translation>Przegląd</translation>
        </message>
        <message>
            <source>&amp;Charts</source>
            <translation>&amp;Wykresy</translation>
        </message>
        <message>
            <source>&amp;Sweep a parameter</source>
            <translation>&amp;Przegląd parametru</translation>
        </message>
        <message>
            <source>Click a point to see why it was classified so</source>
            <translation>Kliknij punkt, aby zobaczyć, dlaczego tak go sklasyfikowano</translation>
        </message>
        <message>
            <source>The highest point of each cell</source>
            <translation>Najwyższy punkt każdej komórki</translation>
        </message>
        <message>
            <source>All heights: click one for the room above it</source>
            <translation>Wszystkie wysokości: kliknij, by zobaczyć wolne miejsce</translation>
        </message>
        <message>
            <source>Show the &amp;hints again</source>
            <translation>Pokaż &amp;wskazówki ponownie</translation>
        </message>
        <message>
            <source>Scans</source>
            <translation>Skany</translation>
        </message>
        <message>
            <source>Units and axes</source>
            <translation>Jednostki i osie</translation>
        </message>
        <message>
            <source>Not the same as when the session was saved: %1</source>
            <translation>Inne niż w chwili zapisania sesji: %1</translation>
        </message>
        <message>
            <source>Units and axes of %1</source>
            <translation>Jednostki i osie pliku %1</translation>
        </message>
        <message>
            <source>Pose of %1</source>
            <translation>Położenie skanu %1</translation>
        </message>
        <message>
            <source>The program ended unexpectedly. The work on %1 as of %2 can be brought back.</source>
            <translation>Program zakończył się niespodziewanie. Pracę nad %1 z %2 można przywrócić.</translation>
        </message>
        <message>
            <source>Bring back</source>
            <translation>Przywróć</translation>
        </message>
        <message>
            <source>Discard</source>
            <translation>Odrzuć</translation>
        </message>
        <message>
            <source>%1: units and axes as set before</source>
            <translation>%1: jednostki i osie jak ustawiono poprzednio</translation>
        </message>
        <message>
            <source>Change…</source>
            <translation>Zmień…</translation>
        </message>
        <message>
            <source>Close</source>
            <translation>Zamknij</translation>
        </message>
        <message>
            <source>One scan must stay.</source>
            <translation>Jeden skan musi pozostać.</translation>
        </message>
        <message>
            <source>Show %1</source>
            <translation>Pokaż %1</translation>
        </message>
        <message>
            <source>Hide %1</source>
            <translation>Ukryj %1</translation>
        </message>
        <message>
            <source>none</source>
            <translation>brak</translation>
        </message>
        <message>
            <source>%1 × %2 × %3 m</source>
            <translation>%1 × %2 × %3 m</translation>
        </message>
        <message>
            <source>Open session</source>
            <translation>Otwórz sesję</translation>
        </message>
        <message>
            <source>Sessions (*.stratascope);;All files (*)</source>
            <translation>Sesje (*.stratascope);;Wszystkie pliki (*)</translation>
        </message>
        <message>
            <source>A session needs scan files; export the stream's cloud and open that.</source>
            <translation>Sesja wymaga plików skanów; wyeksportuj chmurę strumienia i otwórz ją.</translation>
        </message>
        <message>
            <source>Save session</source>
            <translation>Zapisz sesję</translation>
        </message>
        <message>
            <source>Sessions (*.stratascope)</source>
            <translation>Sesje (*.stratascope)</translation>
        </message>
    </context>
    <context>
        <name>stratascope::MapView</name>
        <message>
            <source>2.5D map</source>
            <translation>Mapa 2,5D</translation>
        </message>
        <message>
            <source>Extended 2.5D map</source>
            <translation>Rozszerzona mapa 2,5D</translation>
        </message>
        <message>
            <source>What the colours of both maps mean</source>
            <translation>Co oznaczają kolory obu map</translation>
        </message>
        <message>
            <source>%1 cells of %2</source>
            <translation>%1 komórek po %2</translation>
        </message>
        <message>
            <source>highest below %1</source>
            <translation>najwyższe poniżej %1</translation>
        </message>
        <message>
            <source>highest of each cell</source>
            <translation>najwyższy w każdej komórce</translation>
        </message>
        <message>
            <source>%1 records</source>
            <translation>rekordy: %1</translation>
        </message>
        <message>
            <source>ε %1</source>
            <translation>ε %1</translation>
        </message>
        <message>
            <source>below %1</source>
            <translation>poniżej %1</translation>
        </message>
        <message>
            <source>cell k %1, l %2</source>
            <translation>komórka k %1, l %2</translation>
        </message>
        <message>
            <source>2.5D height %1</source>
            <translation>wysokość 2,5D %1</translation>
        </message>
        <message>
            <source>1 record</source>
            <translation>1 rekord</translation>
        </message>
        <message>
            <source>%1 free over the lowest</source>
            <translation>%1 wolne nad najniższym</translation>
        </message>
        <message>
            <source>inside the clip box</source>
            <translation>wewnątrz pudła</translation>
        </message>
    </context>
    <context>
        <name>stratascope::MessageBar</name>
        <message>
            <source>Close this message</source>
            <translation>Zamknij tę wiadomość</translation>
        </message>
    </context>
    <context>
        <name>stratascope::ParamPanel</name>
        <message>
            <source>More parameters</source>
            <translation>Więcej</translation>
        </message>
        <message>
            <source>Reset all</source>
            <translation>Resetuj</translation>
        </message>
        <message>
            <source>Put every parameter back to its default</source>
            <translation>Przywróć domyślne wartości wszystkich parametrów</translation>
        </message>
        <message>
            <source>All parameters to their defaults</source>
            <translation>Wszystkie parametry do wartości domyślnych</translation>
        </message>
        <message>
            <source>%1 %2 → %3</source>
            <translation>%1 %2 → %3</translation>
        </message>
        <message>
            <source>Point at a parameter to read what raising it does, and which stages run again.</source>
            <translation>Wskaż parametr, aby przeczytać, co daje jego zwiększenie i które etapy zostaną powtórzone.</translation>
        </message>
        <message>
            <source>Default %1.</source>
            <translation>Domyślnie %1.</translation>
        </message>
        <message>
            <source>Acts from %1 on.</source>
            <translation>Działa od etapu %1.</translation>
        </message>
    </context>
    <context>
        <name>stratascope::ParamRow</name>
        <message>
            <source>Back to the default, %1</source>
            <translation>Powrót do wartości domyślnej, %1</translation>
        </message>
    </context>
    <context>
        <name>stratascope::PictureDialog</name>
        <message>
            <source>Save picture with size</source>
            <translation>Zapis obrazu o podanym rozmiarze</translation>
        </message>
        <message>
            <source> pixels</source>
            <translation> pikseli</translation>
        </message>
        <message>
            <source>Save…</source>
            <translation>Zapisz…</translation>
        </message>
        <message>
            <source>Width</source>
            <translation>Szerokość</translation>
        </message>
        <message>
            <source>Height</source>
            <translation>Wysokość</translation>
        </message>
    </context>
    <context>
        <name>stratascope::PipelineBridge</name>
        <message>
            <source>The result could not be drawn: %1</source>
            <translation>Nie można narysować wyniku: %1</translation>
        </message>
    </context>
    <context>
        <name>stratascope::PlanePanel</name>
        <message>
            <source>Filter by class, name or number</source>
            <translation>Filtruj według klasy, nazwy lub numeru</translation>
        </message>
        <message>
            <source>Show from near</source>
            <translation>Pokaż z bliska</translation>
        </message>
        <message>
            <source>Give a name</source>
            <translation>Nadaj nazwę</translation>
        </message>
        <message>
            <source>Copy this row</source>
            <translation>Kopiuj ten wiersz</translation>
        </message>
        <message>
            <source>Write planes</source>
            <translation>Zapisz płaszczyzny</translation>
        </message>
        <message>
            <source>Show all planes</source>
            <translation>Pokaż wszystkie płaszczyzny</translation>
        </message>
        <message>
            <source>#</source>
            <translation>#</translation>
        </message>
        <message>
            <source>Shown or hidden, colour and number</source>
            <translation>Widoczność, kolor i numer</translation>
        </message>
        <message>
            <source>Class</source>
            <translation>Klasa</translation>
        </message>
        <message>
            <source>Name</source>
            <translation>Nazwa</translation>
        </message>
        <message>
            <source>Points</source>
            <translation>Punkty</translation>
        </message>
        <message>
            <source>m²</source>
            <translation>m²</translation>
        </message>
        <message>
            <source>Area its neurons cover</source>
            <translation>Pole pokryte jej neuronami</translation>
        </message>
        <message>
            <source>σ mm</source>
            <translation>σ mm</translation>
        </message>
        <message>
            <source>Mean distance of its points from it</source>
            <translation>Średnia odległość jej punktów od niej</translation>
        </message>
        <message>
            <source>Label %1, normal %2 %3 %4, offset %5</source>
            <translation>Etykieta %1, normalna %2 %3 %4, przesunięcie %5</translation>
        </message>
        <message>
            <source>Colour of plane %1</source>
            <translation>Kolor płaszczyzny %1</translation>
        </message>
        <message>
            <source>Show</source>
            <translation>Pokaż</translation>
        </message>
        <message>
            <source>Hide</source>
            <translation>Ukryj</translation>
        </message>
        <message>
            <source>Hide all others</source>
            <translation>Ukryj wszystkie inne</translation>
        </message>
        <message>
            <source>Colour…</source>
            <translation>Kolor…</translation>
        </message>
        <message>
            <source>Colour of its number</source>
            <translation>Kolor jej numeru</translation>
        </message>
    </context>
    <context>
        <name>stratascope::PresetBar</name>
        <message>
            <source>Presets: all parameters at once</source>
            <translation>Zestawy: wszystkie parametry naraz</translation>
        </message>
        <message>
            <source>Preset</source>
            <translation>Zestaw</translation>
        </message>
        <message>
            <source>Keep, remove, copy</source>
            <translation>Zachowaj, usuń, kopiuj</translation>
        </message>
        <message>
            <source>Keep as own preset…</source>
            <translation>Zachowaj jako własny zestaw…</translation>
        </message>
        <message>
            <source>Remove own preset</source>
            <translation>Usuń własny zestaw</translation>
        </message>
        <message>
            <source>Name of the preset</source>
            <translation>Nazwa zestawu</translation>
        </message>
        <message>
            <source>Keep</source>
            <translation>Zachowaj</translation>
        </message>
        <message>
            <source>Own values</source>
            <translation>Własne wartości</translation>
        </message>
        <message>
            <source>None yet</source>
            <translation>Jeszcze żadnego</translation>
        </message>
        <message>
            <source>A preset needs a name of letters or digits</source>
            <translation>Zestaw musi mieć nazwę z liter lub cyfr</translation>
        </message>
        <message>
            <source>%1: cannot be made; presets cannot be kept</source>
            <translation>%1: nie można utworzyć; nie można zachować zestawów</translation>
        </message>
        <message>
            <source>%1: cannot be removed</source>
            <translation>%1: nie można usunąć</translation>
        </message>
    </context>
    <context>
        <name>stratascope::ProbePanel</name>
        <message>
            <source>Click a point in the cloud, a cell in a map, or a plane in the list: it lights up everywhere.</source>
            <translation>Kliknij punkt w chmurze, komórkę na mapie lub płaszczyznę na liście: podświetli się wszędzie.</translation>
        </message>
    </context>
    <context>
        <name>stratascope::ResidualView</name>
        <message>
            <source>Distance of its points from the plane, mm</source>
            <translation>Odległość punktów od płaszczyzny, mm</translation>
        </message>
    </context>
    <context>
        <name>stratascope::RowPanel</name>
        <message>
            <source>Copy, write to a file</source>
            <translation>Kopiuj, zapisz do pliku</translation>
        </message>
        <message>
            <source>Copy all rows</source>
            <translation>Kopiuj wszystkie wiersze</translation>
        </message>
        <message>
            <source>Copied %1 rows</source>
            <translation>Skopiowano wiersze: %1</translation>
        </message>
        <message>
            <source>Write as CSV…</source>
            <translation>Zapisz jako CSV…</translation>
        </message>
        <message>
            <source>Copied: %1</source>
            <translation>Skopiowano: %1</translation>
        </message>
        <message>
            <source>CSV (*.csv)</source>
            <translation>CSV (*.csv)</translation>
        </message>
        <message>
            <source>Wrote %1</source>
            <translation>Zapisano %1</translation>
        </message>
    </context>
    <context>
        <name>stratascope::ScanDesk</name>
        <message>
            <source>%1: not enough memory to read it; thin the cloud or split it</source>
            <translation>%1: za mało pamięci na odczyt; przerzedź chmurę albo ją podziel</translation>
        </message>
        <message>
            <source>%1: could not be read: %2</source>
            <translation>%1: nie można odczytać: %2</translation>
        </message>
    </context>
    <context>
        <name>stratascope::ScanPanel</name>
        <message>
            <source>Scan</source>
            <translation>Skan</translation>
        </message>
        <message>
            <source>Lines × beams</source>
            <translation>Linie × wiązki</translation>
        </message>
        <message>
            <source>Points</source>
            <translation>Punkty</translation>
        </message>
        <message>
            <source>Pose</source>
            <translation>Położenie</translation>
        </message>
        <message>
            <source>x, y, z in metres; roll, pitch, yaw in degrees: by which the points are moved into the map</source>
            <translation>x, y, z w metrach; przechył, pochylenie, odchylenie w stopniach: tak punkty są przenoszone do mapy</translation>
        </message>
    </context>
    <context>
        <name>stratascope::StageStrip</name>
        <message>
            <source>Stages</source>
            <translation>Etapy</translation>
        </message>
        <message>
            <source>%1: taken over from the run before; took %2 when it last ran</source>
            <translation>%1: przejęte z poprzedniego przebiegu; ostatnio trwało %2</translation>
        </message>
        <message>
            <source>%1: computed for this result in %2</source>
            <translation>%1: obliczone dla tego wyniku w %2</translation>
        </message>
    </context>
    <context>
        <name>stratascope::StatusStrip</name>
        <message>
            <source>Stop computing; the last result stays</source>
            <translation>Zatrzymaj obliczenia; ostatni wynik pozostaje</translation>
        </message>
        <message>
            <source>Drawing</source>
            <translation>Rysowanie</translation>
        </message>
    </context>
    <context>
        <name>stratascope::StreamCounts</name>
        <message>
            <source>received</source>
            <translation>odebrane</translation>
        </message>
        <message>
            <source>complete lines that were taken</source>
            <translation>kompletne linie, które przyjęto</translation>
        </message>
        <message>
            <source>bad CRC</source>
            <translation>zły CRC</translation>
        </message>
        <message>
            <source>telegrams whose check sum is wrong: none of their values is used</source>
            <translation>telegramy z błędną sumą kontrolną: żadna ich wartość nie jest używana</translation>
        </message>
        <message>
            <source>resynchronised</source>
            <translation>resynchronizacje</translation>
        </message>
        <message>
            <source>times the beginning of the next telegram had to be searched for</source>
            <translation>ile razy trzeba było szukać początku następnego telegramu</translation>
        </message>
        <message>
            <source>missing</source>
            <translation>brakujące</translation>
        </message>
        <message>
            <source>lines that never came, or not yet although later ones did</source>
            <translation>linie, które nie nadeszły wcale albo jeszcze nie, choć późniejsze już są</translation>
        </message>
        <message>
            <source>dropped</source>
            <translation>porzucone</translation>
        </message>
        <message>
            <source>complete lines given up since they came faster than they could be taken</source>
            <translation>kompletne linie porzucone, bo nadchodziły szybciej, niż dało się je przyjąć</translation>
        </message>
        <message>
            <source>connecting</source>
            <translation>łączenie</translation>
        </message>
        <message>
            <source>receiving</source>
            <translation>odbiór</translation>
        </message>
        <message>
            <source>paused</source>
            <translation>wstrzymany</translation>
        </message>
        <message>
            <source>ended</source>
            <translation>zakończony</translation>
        </message>
        <message>
            <source>failed</source>
            <translation>niepowodzenie</translation>
        </message>
    </context>
    <context>
        <name>stratascope::StreamDialog</name>
        <message>
            <source>Open stream</source>
            <translation>Otwórz strumień</translation>
        </message>
        <message>
            <source>Replay of a scan file</source>
            <translation>Odtwarzanie pliku skanu</translation>
        </message>
        <message>
            <source>Simulated scanner over a scene</source>
            <translation>Symulowany skaner w scenie</translation>
        </message>
        <message>
            <source>Scanner on a network (TCP)</source>
            <translation>Skaner w sieci (TCP)</translation>
        </message>
        <message>
            <source>Scanner on a serial port</source>
            <translation>Skaner na porcie szeregowym</translation>
        </message>
        <message>
            <source>Source</source>
            <translation>Źródło</translation>
        </message>
        <message>
            <source>As stratascope-cli stream takes it: replay:FILE, tcp://HOST:PORT or serial:DEVICE?baud=N</source>
            <translation>Taki, jaki przyjmuje stratascope-cli stream: replay:PLIK, tcp://HOST:PORT lub serial:URZĄDZENIE?baud=N</translation>
        </message>
        <message>
            <source>Give up after silence of</source>
            <translation>Zrezygnuj po ciszy</translation>
        </message>
        <message>
            <source>Address</source>
            <translation>Adres</translation>
        </message>
        <message>
            <source>Browse…</source>
            <translation>Przeglądaj…</translation>
        </message>
        <message>
            <source>as fast as it goes</source>
            <translation>jak najszybciej</translation>
        </message>
        <message>
            <source>Speed</source>
            <translation>Prędkość</translation>
        </message>
        <message>
            <source>Again and again</source>
            <translation>W kółko</translation>
        </message>
        <message>
            <source>Begin paused</source>
            <translation>Zacznij wstrzymany</translation>
        </message>
        <message>
            <source>Simulated scanner</source>
            <translation>Symulowany skaner</translation>
        </message>
        <message>
            <source>as the scene says</source>
            <translation>jak mówi scena</translation>
        </message>
        <message>
            <source>steps from line to line</source>
            <translation>krokowo, linia po linii</translation>
        </message>
        <message>
            <source>turns while the mirror does</source>
            <translation>obraca się razem z lustrem</translation>
        </message>
        <message>
            <source>Head</source>
            <translation>Głowica</translation>
        </message>
        <message>
            <source>none</source>
            <translation>brak</translation>
        </message>
        <message>
            <source>of the LMS 200</source>
            <translation>jak LMS 200</translation>
        </message>
        <message>
            <source>Noise</source>
            <translation>Szum</translation>
        </message>
        <message>
            <source>The same seed gives the same noise; it rises by one from scan to scan</source>
            <translation>To samo ziarno daje ten sam szum; rośnie o jeden ze skanu na skan</translation>
        </message>
        <message>
            <source>Seed</source>
            <translation>Ziarno</translation>
        </message>
        <message>
            <source>An item of the scene that walks to and fro from scan to scan</source>
            <translation>Element sceny, który chodzi tam i z powrotem ze skanu na skan</translation>
        </message>
        <message>
            <source>Moves</source>
            <translation>Porusza się</translation>
        </message>
        <message>
            <source>Host</source>
            <translation>Host</translation>
        </message>
        <message>
            <source>Port</source>
            <translation>Port</translation>
        </message>
        <message>
            <source>Device</source>
            <translation>Urządzenie</translation>
        </message>
        <message>
            <source>Baud</source>
            <translation>Prędkość (bod)</translation>
        </message>
        <message>
            <source>Head that does not tell where it is</source>
            <translation>Głowica, która nie podaje położenia</translation>
        </message>
        <message>
            <source>A head that speaks, as stratascope-cli serve does, needs none of this</source>
            <translation>Głowica, która je podaje, jak stratascope-cli serve, tego nie potrzebuje</translation>
        </message>
        <message>
            <source>until the stream ends</source>
            <translation>do końca strumienia</translation>
        </message>
        <message>
            <source>13 (8 m or 80 m)</source>
            <translation>13 (8 m lub 80 m)</translation>
        </message>
        <message>
            <source>14 (16 m)</source>
            <translation>14 (16 m)</translation>
        </message>
        <message>
            <source>15 (32 m)</source>
            <translation>15 (32 m)</translation>
        </message>
        <message>
            <source> s</source>
            <translation> s</translation>
        </message>
        <message>
            <source>never</source>
            <translation>nigdy</translation>
        </message>
        <message>
            <source>First line's elevation</source>
            <translation>Elewacja pierwszej linii</translation>
        </message>
        <message>
            <source>From line to line</source>
            <translation>Od linii do linii</translation>
        </message>
        <message>
            <source>Lines of a scan</source>
            <translation>Linii w skanie</translation>
        </message>
        <message>
            <source>Bits of a range</source>
            <translation>Bitów odległości</translation>
        </message>
        <message>
            <source>Scene</source>
            <translation>Scena</translation>
        </message>
        <message>
            <source>Scan</source>
            <translation>Skan</translation>
        </message>
        <message>
            <source>Scene to be scanned</source>
            <translation>Scena do zeskanowania</translation>
        </message>
        <message>
            <source>Scan to be replayed</source>
            <translation>Skan do odtworzenia</translation>
        </message>
        <message>
            <source>Scenes (*.json)</source>
            <translation>Sceny (*.json)</translation>
        </message>
        <message>
            <source>All files (*)</source>
            <translation>Wszystkie pliki (*)</translation>
        </message>
        <message>
            <source>nothing</source>
            <translation>nic</translation>
        </message>
        <message>
            <source>%1: there is no such file</source>
            <translation>%1: nie ma takiego pliku</translation>
        </message>
        <message>
            <source>%1: a scene is a .json file</source>
            <translation>%1: scena to plik .json</translation>
        </message>
    </context>
    <context>
        <name>stratascope::SweepPanel</name>
        <message>
            <source>What each value leads to</source>
            <translation>Do czego prowadzi każda wartość</translation>
        </message>
        <message>
            <source>even</source>
            <translation>równe</translation>
        </message>
        <message>
            <source>geometric</source>
            <translation>geometryczne</translation>
        </message>
        <message>
            <source>Equal differences or equal ratios between neighbours</source>
            <translation>Równe różnice albo równe ilorazy między sąsiadami</translation>
        </message>
        <message>
            <source>Sweep</source>
            <translation>Przegląd</translation>
        </message>
        <message>
            <source>Write the samples to a file</source>
            <translation>Zapisz próbki do pliku</translation>
        </message>
        <message>
            <source>Write as CSV…</source>
            <translation>Zapisz jako CSV…</translation>
        </message>
        <message>
            <source>Save picture…</source>
            <translation>Zapisz obraz…</translation>
        </message>
        <message>
            <source>to</source>
            <translation>do</translation>
        </message>
        <message>
            <source>Parameter</source>
            <translation>Parametr</translation>
        </message>
        <message>
            <source>From</source>
            <translation>Od</translation>
        </message>
        <message>
            <source>Samples</source>
            <translation>Próbki</translation>
        </message>
        <message>
            <source>Cancel</source>
            <translation>Anuluj</translation>
        </message>
        <message>
            <source>Computing …</source>
            <translation>Obliczanie …</translation>
        </message>
        <message>
            <source>not possible</source>
            <translation>niemożliwe</translation>
        </message>
        <message>
            <source>now %1</source>
            <translation>teraz %1</translation>
        </message>
        <message>
            <source>Stopping …</source>
            <translation>Zatrzymywanie …</translation>
        </message>
        <message>
            <source>Sample %1 of %2</source>
            <translation>Próbka %1 z %2</translation>
        </message>
        <message>
            <source>Runs one parameter over a range in the background; the result on screen stays.</source>
            <translation>Zmienia jeden parametr w zakresie, w tle; wynik na ekranie pozostaje.</translation>
        </message>
        <message>
            <source>Click a sample to take its value.</source>
            <translation>Kliknij próbkę, aby przyjąć jej wartość.</translation>
        </message>
        <message>
            <source>Stopped after %1 of %2.</source>
            <translation>Zatrzymano po %1 z %2.</translation>
        </message>
        <message>
            <source>%1 not possible: %2</source>
            <translation>%1 niemożliwych: %2</translation>
        </message>
        <message>
            <source>Other parameters have changed since.</source>
            <translation>Inne parametry zmieniły się od tego czasu.</translation>
        </message>
        <message>
            <source>%1 %2 from the sweep</source>
            <translation>%1 %2 z przeglądu</translation>
        </message>
        <message>
            <source>PNG (*.png)</source>
            <translation>PNG (*.png)</translation>
        </message>
        <message>
            <source>CSV (*.csv)</source>
            <translation>CSV (*.csv)</translation>
        </message>
        <message>
            <source>Wrote %1</source>
            <translation>Zapisano %1</translation>
        </message>
    </context>
    <context>
        <name>stratascope::TransportBar</name>
        <message>
            <source>as fast as it goes</source>
            <translation>jak najszybciej</translation>
        </message>
        <message>
            <source>One line back (←; Ctrl+← 25 lines)</source>
            <translation>Linię wstecz (←; Ctrl+← 25 linii)</translation>
        </message>
        <message>
            <source>Play or pause (Space)</source>
            <translation>Odtwarzaj lub wstrzymaj (spacja)</translation>
        </message>
        <message>
            <source>One line on (→; Ctrl+→ 25 lines)</source>
            <translation>Linię dalej (→; Ctrl+→ 25 linii)</translation>
        </message>
        <message>
            <source>End the stream; what arrived stays</source>
            <translation>Zakończ strumień; to, co nadeszło, pozostaje</translation>
        </message>
        <message>
            <source>Speed; ×1 is the scanner's own, a line in 26.64 ms</source>
            <translation>Prędkość; ×1 to własna prędkość skanera, linia w 26,64 ms</translation>
        </message>
        <message>
            <source>Speed</source>
            <translation>Prędkość</translation>
        </message>
        <message>
            <source>Lines that have arrived, of those the ones in the picture, and of those the ones whose classes and planes hardly change any more. Others are dimmed in the views.</source>
            <translation>Linie, które nadeszły, z nich te na obrazie, a z tych te, których klasy i płaszczyzny prawie się już nie zmieniają. Pozostałe są w widokach przygaszone.</translation>
        </message>
        <message>
            <source>%1 of %2 lines arrived</source>
            <translation>nadeszło %1 z %2 linii</translation>
        </message>
        <message>
            <source>%1 computed</source>
            <translation>obliczone: %1</translation>
        </message>
        <message>
            <source>%1 final</source>
            <translation>ostateczne: %1</translation>
        </message>
    </context>
    <context>
        <name>stratascope::VtkView</name>
        <message>
            <source>Double-click to enlarge this view or to go back</source>
            <translation>Kliknij dwukrotnie, aby powiększyć ten widok lub wrócić</translation>
        </message>
        <message>
            <source>Enlarge this view, or go back to all three</source>
            <translation>Powiększ ten widok albo wróć do wszystkich trzech</translation>
        </message>
    </context>
    <context>
        <name>stratascope::WelcomePage</name>
        <message>
            <source>Drop a scan here</source>
            <translation>Upuść tu skan</translation>
        </message>
        <message>
            <source>3D scans become a cloud with surface classes, a 2.5D map and an extended 2.5D map.
Several files opened together go into one map.</source>
            <translation>Skany 3D stają się chmurą z klasami powierzchni, mapą 2,5D i rozszerzoną mapą 2,5D.
Kilka plików otwartych razem trafia do jednej mapy.</translation>
        </message>
        <message>
            <source>Open a scan…</source>
            <translation>Otwórz skan…</translation>
        </message>
        <message>
            <source>Recent</source>
            <translation>Niedawne</translation>
        </message>
    </context>
</TS>
