// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <CLI/CLI.hpp>
#include <QApplication>
#include <QFile>
#include <QFileInfo>
#include <QSettings>
#include <algorithm>
#include <clocale>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "app/batch.h"
#include "app/cli/frame_options.h"
#include "app/cli/param_options.h"
#include "app/drag_bench.h"
#include "app/flat_window.h"
#include "app/language.h"
#include "app/live_bench.h"
#include "app/main_window.h"
#include "app/picture_dialog.h"
#include "app/window_state.h"
#include "io/export.h"
#include "io/scan_paths.h"
#include "params/param_table.h"
#include "widgets/opengl.h"
#include "widgets/theme.h"

namespace {

struct Arguments {
  std::vector<std::string> files;
  stratascope::cli::ParamOptions params;
  stratascope::cli::FrameOptions frame;
  std::string batch, theme = "system", size, language, picture;
  std::vector<std::string> drag;
  double liveSpeed = 10;
  bool measureDrag = false, measureLive = false;

  bool stream() const { return files.size() == 1 && stratascope::looksLikeStreamAddress(files.front()); }
  QStringList paths() const {
    QStringList list;
    for (const std::string& file : files) list << QFile::decodeName(file.c_str());
    return list;
  }
};

/// Why these cannot be used with a session; empty if they can, or there is none.
std::string sessionProblem(const Arguments& arguments) {
  using namespace stratascope;
  const auto found = std::ranges::find_if(arguments.files, [](const std::string& file) {
    return isSessionName(QFile::decodeName(file.c_str()));
  });
  if (found == arguments.files.end()) return {};
  if (arguments.files.size() > 1) return *found + ": a session is opened alone, without files beside it";
  if (arguments.params.anyGiven() || arguments.frame.frame() != FileFrame{})
    return *found + ": a session brings its own parameters, poses, units and axes; give none beside it";
  return {};
}

/// Why these cannot be opened together; empty if they can.
std::string streamProblem(const Arguments& arguments) {
  using namespace stratascope;
  const auto found = std::ranges::find_if(arguments.files, looksLikeStreamAddress);
  if (found == arguments.files.end()) return {};
  if (arguments.files.size() > 1) return *found + ": a stream is opened alone, without files beside it";
  if (arguments.frame.frame() != FileFrame{}) return *found + ": --units and --axes need a scan file";
  if (!arguments.batch.empty() || arguments.measureDrag)
    return *found + ": --batch and --measure-drag need a scan file";
  if (!looksLikeDeviceAddress(*found)) return {};
  const auto address = streamAddressFromText(*found);
  return address ? std::string() : address.error().message();
}

int complain(const std::string& message, int status) {
  std::fprintf(stderr, "stratascope: %s\n", message.c_str());
  return status;
}

/// Where Qt would abort, as without a display, the program says why in one line and ends. Qt's warnings are
/// for developers.
void onQtMessage(QtMsgType type, const QMessageLogContext&, const QString& text) {
  if (type != QtFatalMsg && type != QtCriticalMsg) return;
  const QString what = text.contains("platform plugin")
                           ? QStringLiteral("no display can be opened; set DISPLAY, or use stratascope-cli")
                           : text.simplified();
  std::fprintf(stderr, "stratascope: %s\n", what.toLocal8Bit().constData());
  if (type == QtFatalMsg) std::_Exit(1);
}

/// Why these cannot be the words after --measure-drag; empty if they can.
std::string dragProblem(const std::vector<std::string>& words) {
  using namespace stratascope;
  if (words.empty()) return {};
  const ParamInfo* info = findParam(words[0]);
  if (!info)
    return "--measure-drag: no parameter " + words[0] + "; did you mean " + nearestParamKey(words[0]) + "?";
  if (info->kind != ParamKind::Real && info->kind != ParamKind::Integer)
    return "--measure-drag: " + words[0] + " has no slider; name a parameter that is a number";
  if (words.size() == 1) return {};
  bool number = false;
  const double seconds = QString::fromStdString(words[1]).toDouble(&number);
  return number && seconds >= 0.1 && seconds <= 600 ? std::string()
                                                    : "--measure-drag: seconds must be from 0.1 to 600";
}

/// Whether a person would see a window.
bool canShowWindows() {
  const QString platform = QGuiApplication::platformName();
  return platform != "offscreen" && !platform.startsWith("minimal") && platform != "vnc";
}

int runFlat(const QString& problem, const Arguments& arguments, const stratascope::cli::Settings& settings) {
  stratascope::FlatWindow window(problem, arguments.params.execution().threads);
  window.setParams(settings.params);
  window.show();
  window.openFiles(arguments.paths(), settings.poses, arguments.frame.frame());
  return QApplication::exec();
}

int runWindow(int argc, char** argv, const Arguments& arguments) {
  using namespace stratascope;
  const auto settings = arguments.params.settings();
  if (!settings) return complain(settings.error().message(), 1);
  if (const size_t poses = settings->poses.size(); poses > 0 && poses != arguments.files.size())
    return complain("--pose: " + std::to_string(poses) + " poses for " +
                        std::to_string(arguments.files.size()) + " scans; give one a scan",
                    2);

  qInstallMessageHandler(onQtMessage);
  prepareOpenGl();
#if QT_VERSION < QT_VERSION_CHECK(6, 0, 0)
  QCoreApplication::setAttribute(Qt::AA_EnableHighDpiScaling);
  QCoreApplication::setAttribute(Qt::AA_UseHighDpiPixmaps);
#endif
  QCoreApplication::setOrganizationName("Stratascope");
  QCoreApplication::setApplicationName("stratascope");
  QCoreApplication::setApplicationVersion(versionText());
  QApplication app(argc, argv);
  std::setlocale(LC_NUMERIC, "C");  // Qt has just taken the user's
  const bool batch = !arguments.batch.empty() || arguments.measureDrag || arguments.measureLive;
  const QString problem = openGlProblem();
  if (!problem.isEmpty() && (batch || !canShowWindows())) return complain(problem.toStdString(), 1);
  applyTheme(Theme::System);
  speak(QString::fromStdString(arguments.language));
  if (!problem.isEmpty()) {
    complain(problem.toStdString() + "; showing the maps from above", 1);
    return runFlat(problem, arguments, *settings);
  }

  MainWindow window(batch ? MainWindow::Keep::Nothing : MainWindow::Keep::Session,
                    arguments.params.execution().threads);
  if (arguments.theme != "system") applyTheme(arguments.theme == "dark" ? Theme::Dark : Theme::Light);
  window.setParams(settings->params);
  if (batch) {
    const QSize size = arguments.size == "small" ? QSize(1280, 800) : QSize(1600, 1000);
    window.resize(size);
    if (arguments.measureDrag) {
      QStringList keys{"epsilon", "epsilon1", "epsilon2", "cell"};
      if (!arguments.drag.empty())
        keys = QStringList(QString::fromUtf8(findParam(arguments.drag.front())->key));
      double seconds = 2;
      if (arguments.drag.size() > 1) seconds = QString::fromStdString(arguments.drag[1]).toDouble();
      new DragBench(window, keys, seconds);
    } else if (arguments.measureLive) {
      new LiveBench(window, arguments.files.front(), arguments.liveSpeed);
    } else {
      new Batch(window, QFile::decodeName(arguments.batch.c_str()),
                pictureSizeFromText(QString::fromStdString(arguments.picture)));
    }
  }
  window.show();
  QStringList files = arguments.paths();
  // A first start shows something: the sample that was installed with the program.
  if (files.isEmpty() && QSettings().value("recentFiles").toStringList().isEmpty()) {
    const QString sample = QCoreApplication::applicationDirPath() +
                           QStringLiteral("/../share/stratascope/samples/stair_hall.pcd");
    if (QFile::exists(sample)) files << QFileInfo(sample).canonicalFilePath();
  }
  if (arguments.measureLive) {
    // It opens the scan itself, again and again.
  } else if (arguments.stream()) {
    StreamRequest request;
    request.address = arguments.files.front();
    window.openStream(request,
                      settings->poses.empty() ? std::nullopt : std::optional(settings->poses.front()));
  } else {
    window.openFiles(files, settings->poses, arguments.frame.frame());
  }
  return app.exec();
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App cli{"Stratascope: 2.5D and extended 2.5D maps from rotating laser scans, in a window"};
  Arguments arguments;
  cli.add_option("files", arguments.files,
                 "Scans to open, or directories of UOS scans (scanNNN.3d); several go into one map; or one "
                 "session (.stratascope); or one stream: tcp://HOST:PORT, "
                 "serial:DEVICE?baud=500000, replay:FILE (a scan, or a scene that is scanned)");
  arguments.frame.addTo(cli);
  arguments.params.addTo(cli);
  cli.add_option("--batch", arguments.batch,
                 "Show the window, write window.png and all results into this folder when done, and quit");
  cli.add_option("--theme", arguments.theme, "system, light or dark")
      ->check(CLI::IsMember({"system", "light", "dark"}));
  cli.add_option("--language", arguments.language,
                 "Language of the window, such as pl; that of the desktop if it is left out");
  cli.add_option("--size", arguments.size,
                 "Size of the window with --batch: large (1600 × 1000) or small (1280 × 800)")
      ->check(CLI::IsMember({"large", "small"}));
  cli.add_option(
      "--picture", arguments.picture,
      "With --batch: also write views.png, the three views in that many pixels, such as 1920x1080");
  CLI::Option* drag = cli.add_option("--measure-drag", arguments.drag,
                                     "Drag the slider of PARAM for SECONDS (default: those of the four main "
                                     "parameters, 2 s each), print how "
                                     "long pictures take to follow, and quit")
                          ->type_name("[PARAM [SECONDS]]")
                          ->expected(0, 2);
  cli.add_flag("--measure-live", arguments.measureLive,
               "Play the scan at ten times the scanner's speed, several times, print how long after the last "
               "line the final picture stands, and quit");
  cli.add_option("--live-speed", arguments.liveSpeed,
                 "With --measure-live: times the scanner's speed instead of 10")
      ->check(CLI::Range(0.25, 50.0));
  cli.set_version_flag("--version", std::string("stratascope ") + stratascope::versionText());
  try {
    cli.parse(argc, argv);
    if (!arguments.batch.empty() && arguments.files.empty())
      return complain("--batch needs a scan to open", 2);
    if (!arguments.picture.empty()) {
      if (arguments.batch.empty()) return complain("--picture goes with --batch", 2);
      if (stratascope::pictureSizeFromText(QString::fromStdString(arguments.picture)).isEmpty())
        return complain(
            "--picture: '" + arguments.picture + "' is no size; give WIDTHxHEIGHT, each from 200 to 8192", 2);
    }
    arguments.measureDrag = drag->count() > 0;
    std::erase(arguments.drag, "");  // the option without words
    if (arguments.measureDrag) {
      if (arguments.files.empty()) return complain("--measure-drag needs a scan to open before it", 2);
      if (const std::string problem = dragProblem(arguments.drag); !problem.empty())
        return complain(problem, 2);
    }
    if (arguments.measureLive && arguments.files.size() != 1)
      return complain("--measure-live needs one scan file", 2);
    for (const std::string& problem : {streamProblem(arguments), sessionProblem(arguments)})
      if (!problem.empty()) return complain(problem, 2);
    auto files = stratascope::scanFiles(arguments.files);
    if (!files) return complain(files.error().message(), 1);
    arguments.files = *std::move(files);
    return runWindow(argc, argv, arguments);
  } catch (const CLI::ParseError& e) {
    if (e.get_exit_code() == 0) return cli.exit(e);  // --help, --version
    return complain(std::string(e.what()) + " (--help tells more)", 2);
  } catch (const stratascope::cli::BadArguments& e) {
    return complain(std::string(e.what()) + " (--help tells more)", 2);
  } catch (const std::exception& e) {
    return complain(e.what(), 3);
  }
}
