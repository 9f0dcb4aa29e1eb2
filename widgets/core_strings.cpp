// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "widgets/core_strings.h"

#include <QCoreApplication>

namespace stratascope {
namespace {

// Core knows no translations: its tables' words stand here once more, for the translator's tools to find. A
// test compares.
const char* const kStrings[] = {
    QT_TRANSLATE_NOOP("Core", "Height gap"),
    QT_TRANSLATE_NOOP("Core",
                      "Heights of a cell that lie closer than this are one interval: raising it joins more, "
                      "up to the robot's height nothing is lost for driving; below the vertical spacing of "
                      "the scan lines walls shatter."),
    QT_TRANSLATE_NOOP("Core", "Outer radius"),
    QT_TRANSLATE_NOOP("Core",
                      "Neighbours farther than this have no say in a normal: raising it steadies normals "
                      "against range noise and rounds off edges and small parts."),
    QT_TRANSLATE_NOOP("Core", "Inner radius"),
    QT_TRANSLATE_NOOP("Core",
                      "Neighbours nearer than this have no say in a normal: raising it keeps noisy short "
                      "differences out; it must stay below the outer radius."),
    QT_TRANSLATE_NOOP("Core", "Cell size"),
    QT_TRANSLATE_NOOP("Core",
                      "Edge of a map cell: raising it gives a coarser, smaller map with fewer empty cells."),
    QT_TRANSLATE_NOOP("Core", "Normal estimator"),
    QT_TRANSLATE_NOOP("Core", "closest"),
    QT_TRANSLATE_NOOP("Core", "adaptive"),
    QT_TRANSLATE_NOOP("Core", "regression"),
    QT_TRANSLATE_NOOP("Core",
                      "How a normal is found: from adjacent beams (fast, very noisy), from the first "
                      "neighbours inside the shell, or by least squares over all points of the shell."),
    QT_TRANSLATE_NOOP("Core", "Plane fit"),
    QT_TRANSLATE_NOOP("Core", "tls"),
    QT_TRANSLATE_NOOP("Core", "paper"),
    QT_TRANSLATE_NOOP("Core",
                      "How a plane is fitted: total least squares, or the paper's regression, which cannot "
                      "hold a plane through the sensor and says so."),
    QT_TRANSLATE_NOOP("Core", "Interval rule"),
    QT_TRANSLATE_NOOP("Core", "linked"),
    QT_TRANSLATE_NOOP("Core",
                      "How heights become intervals: linked by gaps below the height gap, whatever their "
                      "order, or the paper's rule, point by point in the order of the scan."),
    QT_TRANSLATE_NOOP("Core", "Angle tolerance"),
    QT_TRANSLATE_NOOP(
        "Core",
        "Normals closer than this count as parallel: raising it makes surfaces larger and edges thinner."),
    QT_TRANSLATE_NOOP("Core", "Class tolerance"),
    QT_TRANSLATE_NOOP("Core",
                      "A normal this close to an axis is facing, side or horizontal: raising it leaves fewer "
                      "surfaces oblique."),
    QT_TRANSLATE_NOOP("Core", "Plane distance"),
    QT_TRANSLATE_NOOP("Core",
                      "Points farther than this from a plane never belong to it: raising it makes planes "
                      "swallow noise and shallow steps."),
    QT_TRANSLATE_NOOP("Core", "Smallest plane"),
    QT_TRANSLATE_NOOP(
        "Core", "Regions with fewer points than this are no planes: raising it leaves only the large ones."),
    QT_TRANSLATE_NOOP("Core", "Align to walls"),
    QT_TRANSLATE_NOOP("Core",
                      "Measures classes against the building's dominant wall direction and not the sensor's: "
                      "for scans taken askew."),
    QT_TRANSLATE_NOOP("Core", "Join pieces"),
    QT_TRANSLATE_NOOP(
        "Core", "Gives neighbouring pieces of one plane, split by something in front of it, one label."),
    QT_TRANSLATE_NOOP("Core", "Clean classes"),
    QT_TRANSLATE_NOOP("Core",
                      "Lets the majority of the neighbours overrule single neurons of another class."),
    QT_TRANSLATE_NOOP("Core", "Nearest range"),
    QT_TRANSLATE_NOOP(
        "Core", "Returns nearer than this are left out: raising it removes the robot itself; 0 is no limit."),
    QT_TRANSLATE_NOOP("Core", "Farthest range"),
    QT_TRANSLATE_NOOP(
        "Core",
        "Returns farther than this are left out: raising it lets in more of the distance; 0 is no limit."),
    QT_TRANSLATE_NOOP("Core", "Points"),
    QT_TRANSLATE_NOOP("Core", "Normals"),
    QT_TRANSLATE_NOOP("Core", "Classes"),
    QT_TRANSLATE_NOOP("Core", "Planes"),
    QT_TRANSLATE_NOOP("Core", "Edges"),
    QT_TRANSLATE_NOOP("Core", "Cells"),
    QT_TRANSLATE_NOOP("Core", "2.5D map"),
    QT_TRANSLATE_NOOP("Core", "Extended 2.5D map"),
    QT_TRANSLATE_NOOP("Core", "Raster-object map"),
    QT_TRANSLATE_NOOP("Core", "Facing"),
    QT_TRANSLATE_NOOP("Core", "Side"),
    QT_TRANSLATE_NOOP("Core", "Horizontal"),
    QT_TRANSLATE_NOOP("Core", "Oblique"),
    QT_TRANSLATE_NOOP("Core", "Convex edge"),
    QT_TRANSLATE_NOOP("Core", "Concave edge"),
    QT_TRANSLATE_NOOP("Core", "Jump edge"),
    QT_TRANSLATE_NOOP("Core", "Unknown"),
    QT_TRANSLATE_NOOP("Core", "floor"),
    QT_TRANSLATE_NOOP("Core", "ceiling"),
    QT_TRANSLATE_NOOP("Core", "raised"),
    QT_TRANSLATE_NOOP("Core", "As in the paper"),
    QT_TRANSLATE_NOOP("Core", "Driving"),
    QT_TRANSLATE_NOOP("Core", "Fine detail"),
    QT_TRANSLATE_NOOP("Core", "Large halls"),
    QT_TRANSLATE_NOOP("Core", "Nearest neighbours"),
    QT_TRANSLATE_NOOP("Core", "Noisy scanner"),
};

}  // namespace

std::span<const char* const> coreStrings() {
  return kStrings;
}

}  // namespace stratascope
