// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/console/print.h>
#include <pcl/features/integral_image_normal.h>
#include <pcl/features/normal_3d_omp.h>
#include <pcl/point_types.h>
#include <pcl/search/kdtree.h>
#include <pcl/segmentation/organized_multi_plane_segmentation.h>

#include "base/stopwatch.h"
#include "base/units.h"
#include "interop/peers.h"

namespace stratascope {
namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;
using NormalCloud = pcl::PointCloud<pcl::Normal>;

/// Rows of a camera's frame in the map's: x right, y down, z forward. PCL's organised algorithms take z for
/// depth.
Eigen::Matrix3f cameraAxes(const PointImage& points) {
  const Eigen::Vector3d forward = points.viewing.normalized(), down = -Eigen::Vector3d::UnitZ();
  Eigen::Matrix3d axes;
  axes.row(0) = down.cross(forward).normalized();
  axes.row(1) = down;
  axes.row(2) = forward;
  return axes.cast<float>();
}

Cloud::Ptr organisedCloud(const PointImage& points, const Eigen::Matrix3f& axes) {
  auto cloud = std::make_shared<Cloud>(static_cast<std::uint32_t>(points.points.cols()),
                                       static_cast<std::uint32_t>(points.points.rows()));
  for (size_t i = 0; i < points.points.size(); ++i)
    (*cloud)[i].getVector3fMap() =
        axes * (points.points[i].cast<double>() - points.sensor).cast<float>().eval();
  cloud->is_dense = false;
  return cloud;
}

Grid<Eigen::Vector3f> gridOf(const NormalCloud& normals, const Eigen::Matrix3f& axes) {
  Grid<Eigen::Vector3f> grid(static_cast<int>(normals.height), static_cast<int>(normals.width));
  for (size_t i = 0; i < grid.size(); ++i) grid[i] = axes.transpose() * normals[i].getNormalVector3fMap();
  return grid;
}

/// PCL's own comparator, with the distance allowed growing with the square of the range instead of z²: what
/// looks sideways has z = 0.
class RangeComparator : public pcl::PlaneCoefficientComparator<pcl::PointXYZ, pcl::Normal> {
public:
  bool compare(int a, int b) const override {
    const auto i = static_cast<size_t>(a), j = static_cast<size_t>(b);
    const float range2 = (*input_)[i].getVector3fMap().squaredNorm();
    const float threshold = distance_threshold_ * range2;
    return std::abs((*plane_coeff_d_)[i] - (*plane_coeff_d_)[j]) < threshold &&
           (*normals_)[i].getNormalVector3fMap().dot((*normals_)[j].getNormalVector3fMap()) >
               angular_threshold_;
  }
};

/// PCL makes an organised search it then does not use for integral images, and prints that it refuses the
/// scanner.
class Silence {
public:
  Silence() : level_(pcl::console::getVerbosityLevel()) {
    pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS);
  }
  ~Silence() { pcl::console::setVerbosityLevel(level_); }
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;

private:
  pcl::console::VERBOSITY_LEVEL level_;
};

}  // namespace

PeerNormals pclRadiusNormals(const PointImage& points, double radius, int threads) {
  const Eigen::Matrix3f axes = cameraAxes(points);
  const Cloud::Ptr cloud = organisedCloud(points, axes);
  NormalCloud normals;
  const Stopwatch watch;
  pcl::NormalEstimationOMP<pcl::PointXYZ, pcl::Normal> estimation(static_cast<unsigned>(threads));
  const auto tree = std::make_shared<pcl::search::KdTree<pcl::PointXYZ>>(false);
  tree->setInputCloud(cloud);
  estimation.setInputCloud(cloud);
  estimation.setSearchMethod(tree);
  estimation.setRadiusSearch(radius);
  estimation.compute(normals);
  const double seconds = watch.seconds();
  return {gridOf(normals, axes), seconds};
}

PeerNormals pclIntegralImageNormals(const PointImage& points, const PclIntegralSettings& settings) {
  const Eigen::Matrix3f axes = cameraAxes(points);
  const Cloud::Ptr cloud = organisedCloud(points, axes);
  NormalCloud normals;
  const Silence silence;
  const Stopwatch watch;
  pcl::IntegralImageNormalEstimation<pcl::PointXYZ, pcl::Normal> estimation;
  estimation.setNormalEstimationMethod(estimation.COVARIANCE_MATRIX);
  estimation.setMaxDepthChangeFactor(static_cast<float>(settings.maxDepthChange));
  estimation.setNormalSmoothingSize(static_cast<float>(settings.smoothing));
  estimation.setInputCloud(cloud);
  estimation.compute(normals);
  const double seconds = watch.seconds();
  return {gridOf(normals, axes), seconds};
}

PeerPlanes pclMultiPlane(const PointImage& points, const Grid<Eigen::Vector3f>& normals,
                         const PclPlaneSettings& settings) {
  require(normals.size() == points.points.size(), "pclMultiPlane: normals of another lattice");
  const Eigen::Matrix3f axes = cameraAxes(points);
  const Cloud::Ptr cloud = organisedCloud(points, axes);
  const auto given = std::make_shared<NormalCloud>(cloud->width, cloud->height);
  for (size_t i = 0; i < normals.size(); ++i) (*given)[i].getNormalVector3fMap() = axes * normals[i];
  given->is_dense = false;

  std::vector<pcl::PlanarRegion<pcl::PointXYZ>, Eigen::aligned_allocator<pcl::PlanarRegion<pcl::PointXYZ>>>
      regions;
  std::vector<pcl::ModelCoefficients> models;
  std::vector<pcl::PointIndices> inliers, labelIndices, boundaries;
  auto labels = std::make_shared<pcl::PointCloud<pcl::Label>>();
  const Stopwatch watch;
  pcl::OrganizedMultiPlaneSegmentation<pcl::PointXYZ, pcl::Normal, pcl::Label> segmentation;
  segmentation.setMinInliers(static_cast<unsigned>(settings.minInliers));
  segmentation.setAngularThreshold(degToRad(settings.angleDeg));
  segmentation.setDistanceThreshold(settings.distance);
  segmentation.setMaximumCurvature(settings.curvature);
  segmentation.setComparator(std::make_shared<RangeComparator>());
  const auto refinement =
      std::make_shared<pcl::PlaneRefinementComparator<pcl::PointXYZ, pcl::Normal, pcl::Label>>();
  refinement->setDistanceThreshold(static_cast<float>(settings.refineDistance), false);
  segmentation.setRefinementComparator(refinement);
  segmentation.setInputCloud(cloud);
  segmentation.setInputNormals(given);
  segmentation.segmentAndRefine(regions, models, inliers, labels, labelIndices, boundaries);
  PeerPlanes planes;
  planes.seconds = watch.seconds();

  planes.labels = Grid<std::uint32_t>(points.points.rows(), points.points.cols());
  std::map<std::uint32_t, std::uint32_t> ours;  // by PCL's label
  for (size_t i = 0; i < models.size(); ++i) {
    const auto label = static_cast<std::uint32_t>(i + 1);
    ours[(*labels)[static_cast<size_t>(inliers[i].indices.front())].label] = label;
    const Eigen::Vector3f normal(models[i].values[0], models[i].values[1], models[i].values[2]);
    planes.normals[label] = (axes.transpose() * normal).cast<double>().normalized();
  }
  for (size_t i = 0; i < planes.labels.size(); ++i)
    if (const auto label = ours.find((*labels)[i].label); label != ours.end())
      planes.labels[i] = label->second;
  return planes;
}

}  // namespace stratascope
