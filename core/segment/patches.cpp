// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "segment/patches.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/gather_rows.h"
#include "base/units.h"
#include "segment/whole_block.h"

namespace stratascope {

namespace {

// Of the middle of the lattice, so that blocks are about square in space.
int linesPerBlock(const PointImage& points, int blockBeams) {
  const LatticeSteps::Step step = points.steps.at({points.range.rows() / 2, points.range.cols() / 2});
  return std::clamp(static_cast<int>(std::lround(blockBeams * step.beam / std::max(step.line, 1e-6f))), 2,
                    Patches::kMostLines);
}

}  // namespace

Patches::Patches(const Neurons& neurons, const Execution& execution)
    : neurons_(neurons),
      blockLines_(linesPerBlock(neurons.points, kBlockBeams)),
      cosAgree_(static_cast<float>(std::cos(degToRad(std::min(10.0, neurons.params.angleToleranceDeg))))) {
  const int lines = neurons.points.range.rows(), beams = neurons.points.range.cols();
  const int rows = (lines + blockLines_ - 1) / blockLines_, cols = (beams + kBlockBeams - 1) / kBlockBeams;
  patch_ = Grid<std::int32_t>(lines, beams, kNoRegion);
  firstOfBlock_ = Grid<std::int32_t>(rows, cols + 1);
  wholePatch_ = Grid<std::int32_t>(rows, cols, kNoRegion);
  // Rows of blocks label their patches from 0, then all are numbered through.
  std::vector<std::vector<PatchSums>> ofRow(static_cast<size_t>(rows));
  parallelRows(
      rows, execution,
      [&](int begin, int end) {
        std::vector<GridIndex> stack;
        WholeBlock values(neurons_, cosAgree_);
        for (int r = begin; r < end; ++r) {
          std::vector<PatchSums>& sums = ofRow[static_cast<size_t>(r)];
          for (int c = 0; c < cols; ++c) {
            const Block b = block(r, c);
            firstOfBlock_({r, c}) = static_cast<std::int32_t>(sums.size());
            if (b.endBeam - b.beam == kBlockBeams && values.read({b.line, b.beam}, b.endLine - b.line) &&
                values.allAgree()) {
              wholePatch_({r, c}) = static_cast<std::int32_t>(sums.size());
              for (int i = b.line; i < b.endLine; ++i)
                std::fill_n(&patch_({i, b.beam}), kBlockBeams, wholePatch_({r, c}));
              sums.push_back(values.sums());
            } else {
              labelBlock(b, sums, stack);
            }
          }
          firstOfBlock_({r, cols}) = static_cast<std::int32_t>(sums.size());
        }
      },
      1);
  std::vector<std::int32_t> firstOfRow(1, 0);
  for (const auto& sums : ofRow)
    firstOfRow.push_back(firstOfRow.back() + static_cast<std::int32_t>(sums.size()));
  sums_.reserve(static_cast<size_t>(firstOfRow.back()));
  for (auto& sums : ofRow) {
    sums_.insert(sums_.end(), sums.begin(), sums.end());
    sums = {};
  }
  parallelRows(
      rows, execution,
      [&](int begin, int end) {
        for (int r = begin; r < end; ++r) {
          const std::int32_t first = firstOfRow[static_cast<size_t>(r)];
          for (std::int32_t& p : firstOfBlock_.row(r)) p += first;
          for (std::int32_t& p : wholePatch_.row(r)) p += p != kNoRegion ? first : 0;
          for (int i = r * blockLines_; i < std::min(lines, (r + 1) * blockLines_); ++i)
            for (std::int32_t& p : patch_.row(i)) p += p != kNoRegion ? first : 0;
        }
      },
      4);
}

Patches::Block Patches::block(int row, int col) const {
  return {row * blockLines_, std::min(patch_.rows(), (row + 1) * blockLines_), col * kBlockBeams,
          std::min(patch_.cols(), (col + 1) * kBlockBeams)};
}

void Patches::labelBlock(const Block& block, std::vector<PatchSums>& sums, std::vector<GridIndex>& stack) {
  for (int i = block.line; i < block.endLine; ++i)
    for (int j = block.beam; j < block.endBeam; ++j) {
      if (patch_({i, j}) != kNoRegion || !neurons_.hasNormal({i, j})) continue;
      const auto index = static_cast<std::int32_t>(sums.size());
      PatchSums& patch = sums.emplace_back();
      stack.assign(1, {i, j});
      patch_({i, j}) = index;
      while (!stack.empty()) {
        const GridIndex at = stack.back();
        stack.pop_back();
        neurons_.addTo(patch, at);
        for (const GridIndex d : {GridIndex{0, 1}, GridIndex{1, 0}, GridIndex{0, -1}, GridIndex{-1, 0}}) {
          const GridIndex to{at.row + d.row, at.col + d.col};
          if (to.row < block.line || to.row >= block.endLine || to.col < block.beam ||
              to.col >= block.endBeam)
            continue;
          if (patch_(to) != kNoRegion || !neurons_.hasNormal(to) || !agree(at, to)) continue;
          patch_(to) = index;
          stack.push_back(to);
        }
      }
    }
}

bool Patches::agree(GridIndex a, GridIndex b) const {
  const Eigen::Vector3f &n1 = neurons_.normals.normals(a), &n2 = neurons_.normals.normals(b);
  if (n1.dot(n2) < cosAgree_) return false;
  const Eigen::Vector3f difference = neurons_.points.points(b) - neurons_.points.points(a);
  const double off = std::max(std::abs(n1.dot(difference)), std::abs(n2.dot(difference)));
  const double cosine = neurons_.cosine(a);
  return off * off <= kFarSigmas * kFarSigmas * 2 * neurons_.variance(a, cosine) * cosine * cosine;
}

// Blocks that are one patch each touch as a whole; elsewhere every neuron looks one and two on.
void Patches::addTouching(int row, int col, std::vector<LabelPair>& pairs) const {
  const Block b = block(row, col);
  const std::int32_t whole = wholePatch_({row, col});
  const auto look = [&](const Block& from, GridIndex step) {
    for (int i = from.line; i < from.endLine; ++i)
      for (int j = from.beam; j < from.endBeam; ++j) {
        const std::int32_t p = patch_({i, j});
        if (p == kNoRegion) continue;
        for (int reach = 1; reach <= 2; ++reach) {
          const GridIndex to{i + reach * step.row, j + reach * step.col};
          if (!patch_.contains(to)) break;
          const std::int32_t other = patch_(to);
          if (other == kNoRegion || other == p) continue;
          if (pairs.empty() || pairs.back() != LabelPair{p, other}) pairs.push_back({p, other});
        }
      }
  };
  const auto toBlock = [&](GridIndex next, const Block& from, GridIndex step) {
    const std::int32_t other = wholePatch_.contains(next) ? wholePatch_(next) : kNoRegion;
    if (whole != kNoRegion && other != kNoRegion)
      pairs.push_back({whole, other});
    else
      look(whole != kNoRegion ? from : b, step);  // inside a patch there is nothing to find
  };
  toBlock({row, col + 1}, {b.line, b.endLine, std::max(b.beam, b.endBeam - 2), b.endBeam}, {0, 1});
  toBlock({row + 1, col}, {std::max(b.line, b.endLine - 2), b.endLine, b.beam, b.endBeam}, {1, 0});
}

std::vector<LabelPair> Patches::touchingPatches(const Execution& execution) const {
  constexpr int kRows = 4;
  return gatherRows<LabelPair>(
      wholePatch_.rows(), execution,
      [&](int begin, int end, std::vector<LabelPair>& pairs) {
        for (int r = begin; r < end; ++r)
          for (int c = 0; c < wholePatch_.cols(); ++c) addTouching(r, c, pairs);
      },
      kRows);
}

// A block of several regions: patches that lie in one of them whole, neurons where a border cuts a patch.
void Patches::addMixed(const Block& block, const Grid<std::int32_t>& region, RegionSums& sums) const {
  constexpr std::int32_t kCut = -2;
  std::array<std::pair<std::int32_t, std::int32_t>, 4 * kMostLines> seen;  // patch, its region
  size_t patches = 0;
  const auto of = [&](std::int32_t patch) {
    size_t k = 0;
    while (k < patches && seen[k].first != patch) ++k;
    return k;
  };
  for (int i = block.line; i < block.endLine; ++i)
    for (int j = block.beam; j < block.endBeam; ++j) {
      const std::int32_t l = region({i, j}), patch = patch_({i, j});
      if (l != kNoRegion) ++sums.size[static_cast<size_t>(l)];
      if (patch == kNoRegion) continue;
      const size_t k = of(patch);
      if (k == patches)
        seen[patches++] = {patch, l};
      else if (seen[k].second != l)
        seen[k].second = kCut;
    }
  bool anyCut = false;
  for (size_t k = 0; k < patches; ++k) {
    if (seen[k].second >= 0)
      sums.sums[static_cast<size_t>(seen[k].second)] += sums_[static_cast<size_t>(seen[k].first)];
    anyCut = anyCut || seen[k].second == kCut;
  }
  if (!anyCut) return;
  for (int i = block.line; i < block.endLine; ++i)
    for (int j = block.beam; j < block.endBeam; ++j) {
      const std::int32_t l = region({i, j}), patch = patch_({i, j});
      if (l != kNoRegion && patch != kNoRegion && seen[of(patch)].second == kCut)
        neurons_.addTo(sums.sums[static_cast<size_t>(l)], {i, j});
    }
}

void Patches::addRow(int row, const Grid<std::int32_t>& region, RegionSums& sums) const {
  for (int c = 0; c < wholePatch_.cols(); ++c) {
    const Block b = block(row, c);
    const std::int32_t first = region({b.line, b.beam});
    bool whole = true;
    for (int i = b.line; i < b.endLine && whole; ++i)
      for (int j = b.beam; j < b.endBeam; ++j) whole = whole && region({i, j}) == first;
    if (!whole) {
      addMixed(b, region, sums);
    } else if (first != kNoRegion) {
      PatchSums all;
      for (std::int32_t p = firstOfBlock_({row, c}); p < firstOfBlock_({row, c + 1}); ++p)
        all += sums_[static_cast<size_t>(p)];
      sums.sums[static_cast<size_t>(first)] += all;
      sums.size[static_cast<size_t>(first)] +=
          static_cast<size_t>((b.endLine - b.line) * (b.endBeam - b.beam));
    }
  }
}

Patches::RegionSums Patches::sumsOf(const Grid<std::int32_t>& region, std::size_t regions,
                                    const Execution& execution) {
  // Partial sums of a fixed number of rows each, added in order: the same bits for any number of threads.
  constexpr int kParts = 16;
  const int rowsOfPart = std::max(1, (wholePatch_.rows() + kParts - 1) / kParts);
  if (summed_.empty()) summed_ = Grid<std::int32_t>(region.rows(), region.cols(), kNoRegion);
  parts_.resize(static_cast<size_t>((wholePatch_.rows() + rowsOfPart - 1) / rowsOfPart));
  parallelRows(
      wholePatch_.rows(), execution,
      [&](int begin, int end) {
        RegionSums& part = parts_[static_cast<size_t>(begin / rowsOfPart)];
        const size_t first = region.offset({begin * blockLines_, 0}),
                     last = region.offset({std::min(region.rows(), end * blockLines_), 0});
        const auto now = region.values().subspan(first, last - first);
        const auto before = summed_.values().subspan(first, last - first);
        if (part.sums.size() == regions && std::equal(now.begin(), now.end(), before.begin())) return;
        std::copy(now.begin(), now.end(), before.begin());
        part.sums.assign(regions, {});
        part.size.assign(regions, 0);
        for (int r = begin; r < end; ++r) addRow(r, region, part);
      },
      rowsOfPart);
  RegionSums total{std::vector<PatchSums>(regions), std::vector<std::size_t>(regions, 0)};
  for (const RegionSums& part : parts_)
    for (size_t l = 0; l < regions; ++l) total.sums[l] += part.sums[l], total.size[l] += part.size[l];
  return total;
}

}  // namespace stratascope
