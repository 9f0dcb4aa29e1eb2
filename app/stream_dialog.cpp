// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "app/stream_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSettings>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QVBoxLayout>

#include "sim/scene.h"

namespace stratascope {
namespace {

const char* const kGroup = "stream";
const QString kReplay = QStringLiteral("replay:");

QSpinBox* wholeNumber(int low, int high, int value) {
  auto* box = new QSpinBox;
  box->setRange(low, high);
  box->setValue(value);
  return box;
}

QDoubleSpinBox* realNumber(double low, double high, double value, int digits, const QString& unit) {
  auto* box = new QDoubleSpinBox;
  box->setRange(low, high);
  box->setDecimals(digits);
  box->setSingleStep(digits > 1 ? 0.05 : 1);
  box->setValue(value);
  box->setSuffix(unit);
  return box;
}

void choose(QComboBox* box, const QVariant& data, const QString& text) {
  int at = box->findData(data);
  if (at < 0) {
    box->addItem(text, data);
    at = box->count() - 1;
  }
  box->setCurrentIndex(at);
}

QStringList serialDevices() {
  QStringList out;
  const QDir devices(QStringLiteral("/dev"));
  for (const QString& name :
       devices.entryList({"ttyUSB*", "ttyACM*", "ttyS?", "rfcomm*"}, QDir::System | QDir::Files, QDir::Name))
    out << devices.filePath(name);
  out.removeDuplicates();
  if (out.isEmpty()) out << QStringLiteral("/dev/ttyUSB0");
  return out;
}

}  // namespace

StreamDialog::StreamDialog(const QString& folder, Remember remember, QWidget* parent)
    : QDialog(parent), folder_(folder), remember_(remember) {
  setWindowTitle(tr("Open stream"));
  kind_ = new QComboBox;
  kind_->setObjectName("streamKind");
  kind_->addItems({tr("Replay of a scan file"), tr("Simulated scanner over a scene"),
                   tr("Scanner on a network (TCP)"), tr("Scanner on a serial port")});
  auto* top = new QFormLayout;
  top->addRow(tr("Source"), kind_);
  buildPlayed();
  buildDevices();

  address_ = new QLineEdit;
  address_->setObjectName("streamAddress");
  address_->setToolTip(
      tr("As stratascope-cli stream takes it: replay:FILE, tcp://HOST:PORT or "
         "serial:DEVICE?baud=N"));
  giveUpLabel_ = new QLabel(tr("Give up after silence of"));
  auto* bottom = new QFormLayout;
  bottom->addRow(giveUpLabel_, giveUp_);
  bottom->addRow(tr("Address"), address_);
  problem_ = new QLabel;
  problem_->setObjectName("problem");
  problem_->setWordWrap(true);
  problem_->setMinimumHeight(2 * fontMetrics().height() + 4);
  problem_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  buttons_ = new QDialogButtonBox(QDialogButtonBox::Open | QDialogButtonBox::Cancel);
  connect(buttons_, &QDialogButtonBox::accepted, this, &StreamDialog::accept);
  connect(buttons_, &QDialogButtonBox::rejected, this, &QDialog::reject);

  auto* layout = new QVBoxLayout(this);
  layout->addLayout(top);
  for (QGroupBox* box : {fileBox_, sceneBox_, tcpBox_, serialBox_, headBox_}) layout->addWidget(box);
  layout->addLayout(bottom);
  layout->addWidget(problem_);
  layout->addStretch(1);
  layout->addWidget(buttons_);
  setMinimumWidth(520);

  connect(kind_, qOverload<int>(&QComboBox::activated), this, [this] {
    showKind();
    writeAddress();
  });
  connect(address_, &QLineEdit::textEdited, this, &StreamDialog::readAddress);
  StreamRequest first;
  if (remember_ == Remember::Last) {
    QSettings settings;
    settings.beginGroup(kGroup);
    first.address = QFile::encodeName(settings.value("address").toString()).toStdString();
    first.speed = settings.value("speed", 1.0).toDouble();
    first.play.rounds = settings.value("loop").toBool() ? Rounds::Endless : Rounds::Once;
    first.play.head = static_cast<HeadMode>(qBound(0, settings.value("head").toInt(), 2));
    first.play.simulation.noise =
        settings.value("noise", true).toBool() ? NoiseModel::Lms200 : NoiseModel::None;
    first.play.simulation.seed = settings.value("seed", 1).toULongLong();
    first.play.moving = settings.value("moving").toString().toStdString();
    HeadMotion& motion = first.telegrams.motion;
    motion.startDeg = settings.value("headStart", motion.startDeg).toDouble();
    motion.stepDeg = settings.value("headStep", motion.stepDeg).toDouble();
    motion.turnsOn = settings.value("headTurns", motion.turnsOn).toBool();
    motion.lines = settings.value("lines", motion.lines).toInt();
    motion.rangeBits = settings.value("rangeBits", motion.rangeBits).toInt();
    first.telegrams.giveUp = std::chrono::milliseconds(settings.value("giveUpMs", 0).toLongLong());
  }
  if (first.address.empty()) first.address = "replay:";
  setRequest(first);
}

void StreamDialog::buildPlayed() {
  fileBox_ = new QGroupBox;
  auto* form = new QFormLayout(fileBox_);
  file_ = new QLineEdit;
  file_->setObjectName("streamFile");
  fileLabel_ = new QLabel;
  auto* browse = new QPushButton(tr("Browse…"));
  browse->setAutoDefault(false);
  auto* row = new QHBoxLayout;
  row->addWidget(file_, 1);
  row->addWidget(browse);
  form->addRow(fileLabel_, row);
  speed_ = new QComboBox;
  speed_->setObjectName("dialogSpeed");
  for (const auto& [text, speed] : {std::pair{QStringLiteral("×¼"), 0.25},
                                    {QStringLiteral("×½"), 0.5},
                                    {QStringLiteral("×1"), 1.0},
                                    {QStringLiteral("×2"), 2.0},
                                    {QStringLiteral("×5"), 5.0},
                                    {QStringLiteral("×10"), 10.0},
                                    {QStringLiteral("×20"), 20.0},
                                    {QStringLiteral("×50"), 50.0},
                                    {tr("as fast as it goes"), 0.0}})
    speed_->addItem(text, speed);
  form->addRow(tr("Speed"), speed_);
  loop_ = new QCheckBox(tr("Again and again"));
  paused_ = new QCheckBox(tr("Begin paused"));
  auto* checks = new QHBoxLayout;
  checks->addWidget(loop_);
  checks->addWidget(paused_);
  checks->addStretch(1);
  form->addRow(QString(), checks);

  sceneBox_ = new QGroupBox(tr("Simulated scanner"));
  auto* scene = new QFormLayout(sceneBox_);
  head_ = new QComboBox;
  head_->addItems(
      {tr("as the scene says"), tr("steps from line to line"), tr("turns while the mirror does")});
  scene->addRow(tr("Head"), head_);
  noise_ = new QComboBox;
  noise_->addItem(tr("none"), static_cast<int>(NoiseModel::None));
  noise_->addItem(tr("of the LMS 200"), static_cast<int>(NoiseModel::Lms200));
  scene->addRow(tr("Noise"), noise_);
  seed_ = wholeNumber(0, 1000000000, 1);
  seed_->setToolTip(tr("The same seed gives the same noise; it rises by one from scan to scan"));
  scene->addRow(tr("Seed"), seed_);
  moving_ = new QComboBox;
  moving_->setToolTip(tr("An item of the scene that walks to and fro from scan to scan"));
  scene->addRow(tr("Moves"), moving_);

  connect(browse, &QPushButton::clicked, this, &StreamDialog::chooseFile);
  connect(file_, &QLineEdit::textEdited, this, &StreamDialog::writeAddress);
  connect(file_, &QLineEdit::textChanged, this, &StreamDialog::fillMoving);
}

void StreamDialog::buildDevices() {
  tcpBox_ = new QGroupBox;
  auto* tcp = new QFormLayout(tcpBox_);
  host_ = new QLineEdit(QStringLiteral("127.0.0.1"));
  host_->setObjectName("streamHost");
  port_ = wholeNumber(1, 65535, 2111);
  port_->setObjectName("streamPort");
  tcp->addRow(tr("Host"), host_);
  tcp->addRow(tr("Port"), port_);

  serialBox_ = new QGroupBox;
  auto* serial = new QFormLayout(serialBox_);
  device_ = new QComboBox;
  device_->setObjectName("streamDevice");
  device_->setEditable(true);
  device_->addItems(serialDevices());
  baud_ = new QComboBox;
  for (const int baud : {9600, 19200, 38400, 500000}) baud_->addItem(QString::number(baud), baud);
  serial->addRow(tr("Device"), device_);
  serial->addRow(tr("Baud"), baud_);

  headBox_ = new QGroupBox(tr("Head that does not tell where it is"));
  headBox_->setToolTip(tr("A head that speaks, as stratascope-cli serve does, needs none of this"));
  auto* head = new QFormLayout(headBox_);
  headStart_ = realNumber(-180, 180, -15, 3, QStringLiteral("°"));
  headStep_ = realNumber(-45, 45, 0.2, 4, QStringLiteral("°"));
  headTurns_ = new QCheckBox(tr("turns while the mirror does"));
  lines_ = wholeNumber(0, 100000, 0);
  lines_->setSpecialValueText(tr("until the stream ends"));
  rangeBits_ = new QComboBox;
  rangeBits_->addItem(tr("13 (8 m or 80 m)"), 13);
  rangeBits_->addItem(tr("14 (16 m)"), 14);
  rangeBits_->addItem(tr("15 (32 m)"), 15);
  giveUp_ = realNumber(0, 86400, 0, 1, tr(" s"));
  giveUp_->setSpecialValueText(tr("never"));
  head->addRow(tr("First line's elevation"), headStart_);
  head->addRow(tr("From line to line"), headStep_);
  head->addRow(QString(), headTurns_);
  head->addRow(tr("Lines of a scan"), lines_);
  head->addRow(tr("Bits of a range"), rangeBits_);

  connect(host_, &QLineEdit::textEdited, this, &StreamDialog::writeAddress);
  connect(port_, qOverload<int>(&QSpinBox::valueChanged), this, &StreamDialog::writeAddress);
  connect(device_, &QComboBox::currentTextChanged, this, &StreamDialog::writeAddress);
  connect(baud_, qOverload<int>(&QComboBox::activated), this, &StreamDialog::writeAddress);
}

StreamDialog::Kind StreamDialog::kindOf(const std::string& address) {
  if (looksLikeDeviceAddress(address)) return address.starts_with("tcp") ? Kind::Tcp : Kind::Serial;
  return isScene(playedFile(address)) ? Kind::Scene : Kind::Replay;
}

StreamDialog::Kind StreamDialog::kind() const {
  return static_cast<Kind>(kind_->currentIndex());
}

void StreamDialog::setKind(Kind kind) {
  kind_->setCurrentIndex(static_cast<int>(kind));
  showKind();
}

void StreamDialog::showKind() {
  const Kind k = kind();
  const bool played = k == Kind::Replay || k == Kind::Scene;
  fileLabel_->setText(k == Kind::Scene ? tr("Scene") : tr("Scan"));
  fileBox_->setVisible(played);
  sceneBox_->setVisible(k == Kind::Scene);
  tcpBox_->setVisible(k == Kind::Tcp);
  serialBox_->setVisible(k == Kind::Serial);
  for (QWidget* w :
       {static_cast<QWidget*>(headBox_), static_cast<QWidget*>(giveUpLabel_), static_cast<QWidget*>(giveUp_)})
    w->setVisible(!played);
  layout()->activate();
  adjustSize();
}

void StreamDialog::chooseFile() {
  const bool scene = kind() == Kind::Scene;
  const QString at = QFileInfo(file_->text()).absolutePath();
  const QString path = QFileDialog::getOpenFileName(
      this, scene ? tr("Scene to be scanned") : tr("Scan to be replayed"),
      file_->text().isEmpty() ? folder_ : at, scene ? tr("Scenes (*.json)") : tr("All files (*)"));
  if (path.isEmpty()) return;
  file_->setText(path);
  writeAddress();
}

void StreamDialog::fillMoving() {
  const QString was = moving_->currentData().toString();
  moving_->clear();
  moving_->addItem(tr("nothing"), QString());
  const std::string file = QFile::encodeName(file_->text()).toStdString();
  if (isScene(file))
    if (const auto scene = loadScene(file))
      for (const Scene::Item& item : scene->items)
        if (!item.name.empty() && moving_->findData(QString::fromStdString(item.name)) < 0)
          moving_->addItem(QString::fromStdString(item.name), QString::fromStdString(item.name));
  moving_->setCurrentIndex(std::max(0, moving_->findData(was)));
}

void StreamDialog::writeAddress() {
  QString address;
  switch (kind()) {
    case Kind::Tcp: {
      const QString host = host_->text().trimmed();
      address =
          QStringLiteral("tcp://%1:%2").arg(host.contains(':') ? "[" + host + "]" : host).arg(port_->value());
      break;
    }
    case Kind::Serial:
      address =
          QStringLiteral("serial:%1?baud=%2").arg(device_->currentText().trimmed(), baud_->currentText());
      break;
    default:
      address = kReplay + file_->text();
  }
  address_->setText(address);
  check();
}

void StreamDialog::readAddress() {
  const std::string text = QFile::encodeName(address_->text().trimmed()).toStdString();
  const std::array<QSignalBlocker, 4> quiet{QSignalBlocker(host_), QSignalBlocker(port_),
                                            QSignalBlocker(device_), QSignalBlocker(baud_)};
  if (looksLikeDeviceAddress(text)) {
    setKind(kindOf(text));
    if (const auto address = streamAddressFromText(text)) {
      if (address->kind == StreamAddress::Kind::Tcp) {
        host_->setText(QString::fromStdString(address->host));
        port_->setValue(address->port);
      } else {
        device_->setEditText(QString::fromStdString(address->host));
        choose(baud_, static_cast<int>(address->baud), QString::number(address->baud));
      }
    }
  } else {
    const std::string file = playedFile(text);
    if (!file.empty() || kind() == Kind::Tcp || kind() == Kind::Serial) setKind(kindOf(text));
    file_->setText(QFile::decodeName(file.c_str()));
  }
  check();
}

void StreamDialog::check() {
  const std::string text = QFile::encodeName(address_->text().trimmed()).toStdString();
  QString problem;
  bool ready = true;
  if (looksLikeDeviceAddress(text)) {
    if (const auto address = streamAddressFromText(text); !address)
      problem = QString::fromStdString(address.error().message());
  } else {
    const QString file = QFile::decodeName(playedFile(text).c_str());
    ready = !file.isEmpty();
    if (ready && !QFileInfo(file).isFile())
      problem = tr("%1: there is no such file").arg(file);
    else if (ready && kind() == Kind::Scene && !isScene(file.toStdString()))
      problem = tr("%1: a scene is a .json file").arg(QFileInfo(file).fileName());
  }
  problem_->setText(problem);
  buttons_->button(QDialogButtonBox::Open)->setEnabled(ready && problem.isEmpty());
}

StreamRequest StreamDialog::request() const {
  StreamRequest r;
  r.address = QFile::encodeName(address_->text().trimmed()).toStdString();
  r.speed = speed_->currentData().toDouble();
  r.paused = paused_->isChecked();
  r.play.rounds = loop_->isChecked() ? Rounds::Endless : Rounds::Once;
  r.play.head = static_cast<HeadMode>(head_->currentIndex());
  r.play.simulation.noise = static_cast<NoiseModel>(noise_->currentData().toInt());
  r.play.simulation.seed = static_cast<std::uint64_t>(seed_->value());
  if (isScene(playedFile(r.address))) r.play.moving = moving_->currentData().toString().toStdString();
  r.telegrams.motion.startDeg = headStart_->value();
  r.telegrams.motion.stepDeg = headStep_->value();
  r.telegrams.motion.turnsOn = headTurns_->isChecked();
  r.telegrams.motion.lines = lines_->value();
  r.telegrams.motion.rangeBits = rangeBits_->currentData().toInt();
  r.telegrams.giveUp = std::chrono::milliseconds(static_cast<std::int64_t>(1000 * giveUp_->value()));
  return r;
}

void StreamDialog::setRequest(const StreamRequest& r) {
  choose(speed_, r.speed, QStringLiteral("×%1").arg(r.speed));
  paused_->setChecked(r.paused);
  loop_->setChecked(r.play.rounds == Rounds::Endless);
  head_->setCurrentIndex(static_cast<int>(r.play.head));
  noise_->setCurrentIndex(noise_->findData(static_cast<int>(r.play.simulation.noise)));
  seed_->setValue(static_cast<int>(std::min<std::uint64_t>(r.play.simulation.seed, 1000000000)));
  headStart_->setValue(r.telegrams.motion.startDeg);
  headStep_->setValue(r.telegrams.motion.stepDeg);
  headTurns_->setChecked(r.telegrams.motion.turnsOn);
  lines_->setValue(r.telegrams.motion.lines);
  rangeBits_->setCurrentIndex(std::max(0, rangeBits_->findData(r.telegrams.motion.rangeBits)));
  giveUp_->setValue(static_cast<double>(r.telegrams.giveUp.count()) / 1000);
  setKind(kindOf(r.address));
  address_->setText(QFile::decodeName(r.address.c_str()));
  readAddress();
  fillMoving();
  moving_->setCurrentIndex(std::max(0, moving_->findData(QString::fromStdString(r.play.moving))));
}

void StreamDialog::accept() {
  if (remember_ == Remember::Last) {
    const StreamRequest r = request();
    QSettings settings;
    settings.beginGroup(kGroup);
    settings.setValue("address", address_->text().trimmed());
    settings.setValue("speed", r.speed);
    settings.setValue("loop", r.play.rounds == Rounds::Endless);
    settings.setValue("head", static_cast<int>(r.play.head));
    settings.setValue("noise", r.play.simulation.noise == NoiseModel::Lms200);
    settings.setValue("seed", static_cast<qulonglong>(r.play.simulation.seed));
    settings.setValue("moving", QString::fromStdString(r.play.moving));
    const HeadMotion& motion = r.telegrams.motion;
    settings.setValue("headStart", motion.startDeg);
    settings.setValue("headStep", motion.stepDeg);
    settings.setValue("headTurns", motion.turnsOn);
    settings.setValue("lines", motion.lines);
    settings.setValue("rangeBits", motion.rangeBits);
    settings.setValue("giveUpMs", static_cast<qlonglong>(r.telegrams.giveUp.count()));
  }
  QDialog::accept();
}

}  // namespace stratascope
