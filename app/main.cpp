// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <QApplication>
#include <QFile>
#include <CLI/CLI.hpp>
#include <clocale>
#include <cstdio>
#include <string>
#include <vector>

#include "app/batch.h"
#include "app/main_window.h"
#include "io/export.h"
#include "params/param_table.h"
#include "widgets/theme.h"
#include "widgets/vtk_view.h"

namespace {

struct Arguments {
  std::vector<std::string> files, poses;
  std::string paramsFile, batch, theme = "system", size;
};

int complain(const std::string& message, int status) {
  std::fprintf(stderr, "stratascope: %s\n", message.c_str());
  return status;
}

int runWindow(int argc, char** argv, const Arguments& arguments) {
  using namespace stratascope;
  std::vector<Eigen::Isometry3d> poses;
  for (const std::string& text : arguments.poses) {
    const auto pose = poseFromText(text);
    if (!pose) return complain(pose.error().message(), 2);
    poses.push_back(*pose);
  }
  PipelineParams params;
  if (!arguments.paramsFile.empty()) {
    const auto loaded = loadParams(arguments.paramsFile);
    if (!loaded) return complain(loaded.error().message(), 1);
    params = *loaded;
  }

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
  if (const QString problem = openGlProblem(); !problem.isEmpty()) return complain(problem.toStdString(), 1);
  applyTheme(arguments.theme == "dark" ? Theme::Dark : arguments.theme == "light" ? Theme::Light : Theme::System);

  const bool batch = !arguments.batch.empty();
  MainWindow window(batch ? MainWindow::Keep::Nothing : MainWindow::Keep::Session);
  window.setParams(params);
  if (batch) {
    const QSize size = arguments.size == "small" ? QSize(1280, 800) : QSize(1600, 1000);
    window.resize(size);
    new Batch(window, QFile::decodeName(arguments.batch.c_str()));
  }
  window.show();
  QStringList files;
  for (const std::string& file : arguments.files) files << QFile::decodeName(file.c_str());
  window.openFiles(files, poses);
  return app.exec();
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App cli{"Stratascope: 2.5D and extended 2.5D maps from rotating laser scans, in a window"};
  Arguments arguments;
  cli.add_option("files", arguments.files, "Scans to open; several go into one map");
  cli.add_option("--params", arguments.paramsFile, "Parameters from a JSON file");
  cli.add_option("--pose", arguments.poses,
                 "x,y,z,roll,pitch,yaw of the sensor in the map (metres, degrees), once a file: for scans in the sensor's own frame");
  cli.add_option("--batch", arguments.batch,
                 "Show the window, write window.png and all results into this folder when done, and quit");
  cli.add_option("--theme", arguments.theme, "system, light or dark")->check(CLI::IsMember({"system", "light", "dark"}));
  cli.add_option("--size", arguments.size, "Size of the window with --batch: large (1600 × 1000) or small (1280 × 800)")
      ->check(CLI::IsMember({"large", "small"}));
  cli.set_version_flag("--version", std::string("stratascope ") + stratascope::versionText());
  try {
    cli.parse(argc, argv);
    if (!arguments.batch.empty() && arguments.files.empty()) return complain("--batch needs a scan to open", 2);
    return runWindow(argc, argv, arguments);
  } catch (const CLI::ParseError& e) {
    return cli.exit(e) == 0 ? 0 : 2;
  } catch (const std::exception& e) {
    return complain(e.what(), 3);
  }
}
