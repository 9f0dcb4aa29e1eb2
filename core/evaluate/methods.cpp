// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/methods.h"

#include "interop/peers.h"
#include "layers/point_layer.h"
#include "pipeline/pipeline.h"

namespace stratascope {
namespace {

struct MethodNames {
  const char *name, *key;
};
constexpr MethodNames kNames[kMethodCount] = {{"Stratascope", "stratascope"},
                                              {"PCL radius 0.10 m + multi-plane", "pcl_radius"},
                                              {"PCL integral image + multi-plane", "pcl_integral"}};

Expected<MethodResult> runStratascope(const ScanPtr& scan, const PipelineParams& params,
                                      const Execution& execution) {
  Pipeline pipeline;
  pipeline.setScans({scan});
  Execution apart = execution;
  apart.oneStageAtATime = true;
  const auto snapshot = pipeline.run(params, apart);
  if (!snapshot) return snapshot.error();
  const ScanProducts& products = (*snapshot)->scans.front();
  MethodResult result;
  result.labels = products.planes->labels;
  result.normals = products.normals->normals;
  for (const Plane& plane : products.planes->planes) result.planeNormals[plane.label] = plane.normal;
  const auto seconds = [&](Stage stage) { return (*snapshot)->stages[static_cast<size_t>(stage)].seconds; };
  result.normalSeconds = seconds(Stage::Points) + seconds(Stage::Normals);
  result.seconds = result.normalSeconds + seconds(Stage::Classes) + seconds(Stage::Planes);
  return result;
}

MethodResult runPcl(Method method, const Scan& scan, const PipelineParams& params,
                    const Execution& execution) {
  const PointImage points = computePoints(scan, params.range, execution);
  const bool radius = method == Method::PclRadius;
  PeerNormals normals =
      radius ? pclRadiusNormals(points, kPclRadius, execution.threads) : pclIntegralImageNormals(points);
  PeerPlanes planes =
      pclMultiPlane(points, normals.normals, radius ? kPclPlanesOfRadius : kPclPlanesOfIntegralImage);
  return {std::move(planes.labels), std::move(normals.normals), std::move(planes.normals), normals.seconds,
          normals.seconds + planes.seconds};
}

}  // namespace

const char* methodName(Method method) {
  return kNames[static_cast<size_t>(method)].name;
}

const char* methodKey(Method method) {
  return kNames[static_cast<size_t>(method)].key;
}

std::vector<Method> methodsBuiltIn() {
  if (pclVersion().empty()) return {Method::Stratascope};
  return {Method::Stratascope, Method::PclRadius, Method::PclIntegral};
}

Expected<MethodResult> runMethod(Method method, const ScanPtr& scan, const PipelineParams& params,
                                 const Execution& execution) {
  if (method == Method::Stratascope) return runStratascope(scan, params, execution);
  return runPcl(method, *scan, params, execution);
}

}  // namespace stratascope
