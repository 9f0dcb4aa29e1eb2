// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "io/provenance.h"
#include "pipeline/snapshot.h"

namespace stratascope {

/// Planes and edges for spreadsheets, GIS and CAD; scan by scan in the order of planes.json and edges.json.
/// Coordinates in metres, map frame.

/// label,class,role,normal_x,normal_y,normal_z,offset,sigma,rms,points,centroid_x,centroid_y,centroid_z,area,scan.
/// A number that is not known is an empty field.
std::string planesCsv(const Snapshot& snapshot);
/// kind,vertical,from_x,from_y,from_z,to_x,to_y,to_z,points,sigma,scan
std::string edgesCsv(const Snapshot& snapshot);

/// AutoCAD R12: every plane's outline a closed 3D polyline on a layer named after its class (FACING, SIDE,
/// HORIZONTAL, OBLIQUE; planes of no class on UNKNOWN), every edge a line on CONVEX_EDGE, CONCAVE_EDGE or
/// JUMP_EDGE. Provenance as comments (group 999).
std::string outlinesDxf(const Snapshot& snapshot, const Provenance& provenance);

/// FeatureCollection with the planes' properties as in planes.json. A plane seen from above is a Polygon with
/// its ring counter-clockwise; an upright one (normal within 6° of level) has no area there and is the
/// LineString of its foot, with min_z and max_z. Edges are LineStrings. "coordinates" and "provenance" of the
/// collection say what no longitude and latitude are.
std::string outlinesGeoJson(const Snapshot& snapshot, const Provenance& provenance);

}  // namespace stratascope
