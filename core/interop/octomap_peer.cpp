// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <octomap/OcTree.h>
#include <octomap/Pointcloud.h>

#include "base/stopwatch.h"
#include "interop/peers.h"

namespace stratascope {
namespace {

octomap::Pointcloud cloudOf(const PointImage& points) {
  octomap::Pointcloud cloud;
  cloud.reserve(points.points.size());
  for (const Eigen::Vector3f& p : points.points.values())
    if (p.allFinite()) cloud.push_back(p.x(), p.y(), p.z());
  return cloud;
}

}  // namespace

PeerMap octomapWithRays(const PointImage& points, double resolution, OctomapCalls calls) {
  const octomap::Pointcloud cloud = cloudOf(points);
  const Eigen::Vector3f sensor = points.sensor.cast<float>();
  const Stopwatch watch;
  octomap::OcTree tree(resolution);
  const octomap::point3d from(sensor.x(), sensor.y(), sensor.z());
  if (calls == OctomapCalls::Singly) {
    tree.insertPointCloudRays(cloud, from);
  } else {
    // Lazily: inner nodes are brought up to date and joined once, at the end; half the time of doing it as
    // one goes.
    tree.insertPointCloud(cloud, from, -1, true);
    tree.updateInnerOccupancy();
    tree.prune();
  }
  const double seconds = watch.seconds();
  return {tree.memoryUsage(), seconds};
}

PeerMap octomapEndPoints(const PointImage& points, double resolution, OctomapCalls calls) {
  const octomap::Pointcloud cloud = cloudOf(points);
  const Stopwatch watch;
  octomap::OcTree tree(resolution);
  const bool lazily = calls == OctomapCalls::Together;
  for (const octomap::point3d& p : cloud) tree.updateNode(p, true, lazily);
  if (lazily) tree.updateInnerOccupancy();
  const double seconds = watch.seconds();
  return {tree.memoryUsage(), seconds};
}

}  // namespace stratascope
