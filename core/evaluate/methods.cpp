// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/methods.h"

#include "pipeline/pipeline.h"

namespace stratascope {
namespace {

struct MethodNames {
  const char *name, *key;
};
constexpr MethodNames kNames[kMethodCount] = {{"Stratascope", "stratascope"}};

Expected<MethodResult> runStratascope(const ScanPtr& scan, const PipelineParams& params,
                                      const Execution& execution) {
  Pipeline pipeline;
  pipeline.setScans({scan});
  const auto snapshot = pipeline.run(params, execution);
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

}  // namespace

const char* methodName(Method method) {
  return kNames[static_cast<size_t>(method)].name;
}

const char* methodKey(Method method) {
  return kNames[static_cast<size_t>(method)].key;
}

std::vector<Method> methodsBuiltIn() {
  return {Method::Stratascope};
}

Expected<MethodResult> runMethod(Method method, const ScanPtr& scan, const PipelineParams& params,
                                 const Execution& execution) {
  switch (method) {
    case Method::Stratascope:
      return runStratascope(scan, params, execution);
  }
  throw std::logic_error("runMethod: not built in");
}

}  // namespace stratascope
