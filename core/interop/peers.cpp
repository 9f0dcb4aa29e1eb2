// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "interop/peers.h"

namespace stratascope {

#ifdef STRATASCOPE_PCL
std::string pclVersion() {
  return STRATASCOPE_PCL;
}
#else
std::string pclVersion() {
  return "";
}

PeerNormals pclRadiusNormals(const PointImage&, double, int) {
  throw std::logic_error("PCL is not built in");
}

PeerNormals pclIntegralImageNormals(const PointImage&, const PclIntegralSettings&) {
  throw std::logic_error("PCL is not built in");
}

PeerPlanes pclMultiPlane(const PointImage&, const Grid<Eigen::Vector3f>&, const PclPlaneSettings&) {
  throw std::logic_error("PCL is not built in");
}
#endif

#ifdef STRATASCOPE_OCTOMAP
std::string octomapVersion() {
  return STRATASCOPE_OCTOMAP;
}
#else
std::string octomapVersion() {
  return "";
}

PeerMap octomapWithRays(const PointImage&, double, OctomapCalls) {
  throw std::logic_error("OctoMap is not built in");
}

PeerMap octomapEndPoints(const PointImage&, double, OctomapCalls) {
  throw std::logic_error("OctoMap is not built in");
}
#endif

}  // namespace stratascope
