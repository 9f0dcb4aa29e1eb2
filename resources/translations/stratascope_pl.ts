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
            <source>#</source>
            <translation>#</translation>
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
            <source>σ mm</source>
            <translation>σ mm</translation>
        </message>
        <message>
            <source>Label %1, normal %2 %3 %4, offset %5</source>
            <translation>Etykieta %1, normalna %2 %3 %4, przesunięcie %5</translation>
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
            <source>%1: could not be read: %2</source>
            <translation>%1: nie można wczytać: %2</translation>
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
            <source>Copy, write to a file</source>
            <translation>Kopiuj, zapisz do pliku</translation>
        </message>
        <message>
            <source>Copy all rows</source>
            <translation>Kopiuj wszystkie wiersze</translation>
        </message>
        <message>
            <source>Copied %1 planes</source>
            <translation>Skopiowano płaszczyzny: %1</translation>
        </message>
        <message>
            <source>Write as CSV…</source>
            <translation>Zapisz jako CSV…</translation>
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
            <source>Copied plane %1</source>
            <translation>Skopiowano płaszczyznę %1</translation>
        </message>
        <message>
            <source>Write planes</source>
            <translation>Zapisz płaszczyzny</translation>
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
