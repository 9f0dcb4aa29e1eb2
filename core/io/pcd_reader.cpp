// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "io/pcd_reader.h"

#include <bit>
#include <cmath>
#include <cstring>

#include "base/units.h"
#include "io/local_origin.h"
#include "io/lzf.h"
#include "io/text_lines.h"

namespace stratascope {

static_assert(std::endian::native == std::endian::little, "PCD's binary encodings are little-endian");

namespace {

using Columns = std::vector<std::vector<double>>;

const char* const kCutOff = "the file is cut off or its header is wrong: copy or save it again";

template <class T>
double loadAs(const char* bytes) {
  T value;
  std::memcpy(&value, bytes, sizeof value);
  return static_cast<double>(value);
}

using Loader = double (*)(const char*);

Loader loaderFor(const PcdField& field) {
  if (field.type == 'F') return field.size == 8 ? loadAs<double> : loadAs<float>;
  const bool isSigned = field.type == 'I';
  switch (field.size) {
    case 1:
      return isSigned ? loadAs<std::int8_t> : loadAs<std::uint8_t>;
    case 2:
      return isSigned ? loadAs<std::int16_t> : loadAs<std::uint16_t>;
    case 4:
      return isSigned ? loadAs<std::int32_t> : loadAs<std::uint32_t>;
    default:
      return isSigned ? loadAs<std::int64_t> : loadAs<std::uint64_t>;
  }
}

Columns emptyColumns(const PcdHeader& header, const std::vector<size_t>& fields) {
  return Columns(fields.size(), std::vector<double>(header.points));
}

/// offsetOf(f): where field f of point 0 starts; strideOf(f): from there to the next point's.
template <class Offset, class Stride>
Columns gather(std::string_view body, const PcdHeader& header, const std::vector<size_t>& fields,
               Offset offsetOf, Stride strideOf) {
  Columns columns = emptyColumns(header, fields);
  for (size_t c = 0; c < fields.size(); ++c) {
    const Loader load = loaderFor(header.fields[fields[c]]);
    const char* from = body.data() + offsetOf(fields[c]);
    const std::uint64_t stride = strideOf(fields[c]);
    for (std::uint64_t i = 0; i < header.points; ++i) columns[c][i] = load(from + i * stride);
  }
  return columns;
}

std::uint64_t offsetInPoint(const PcdHeader& header, size_t field) {
  std::uint64_t offset = 0;
  for (size_t f = 0; f < field; ++f) offset += header.fields[f].size * header.fields[f].count;
  return offset;
}

/// Bytes of all points unpacked; none if 64 bits cannot hold it.
std::optional<std::uint64_t> bodyBytes(const PcdHeader& header) {
  std::uint64_t product = 0;
  if (__builtin_mul_overflow(header.points, header.pointBytes, &product)) return std::nullopt;
  return product;
}

/// PCL before 1.7 wrote files longer by one memory page less the header, filled with zeros. Just that is
/// forgiven.
bool isPagePadding(std::string_view tail, const PcdHeader& header) {
  for (const std::uint64_t page : {4096, 16384, 65536})
    if (tail.size() + header.bodyOffset == page)
      return tail.find_first_not_of('\0') == std::string_view::npos;
  return false;
}

Error wrongLength(const std::string& path, const PcdHeader& header, std::uint64_t available) {
  const auto needed = bodyBytes(header);
  return {path, "byte " + std::to_string(header.bodyOffset),
          std::to_string(header.points) + " points of " + std::to_string(header.pointBytes) + " bytes are " +
              (needed ? std::to_string(*needed) : "more than 2^64") + " bytes, but " +
              std::to_string(available) + " follow the header",
          kCutOff};
}

Expected<Columns> readBinary(const std::string& path, std::string_view bytes, const PcdHeader& header,
                             const std::vector<size_t>& fields) {
  const std::string_view body = bytes.substr(header.bodyOffset);
  const auto needed = bodyBytes(header);
  if (!needed || body.size() < *needed ||
      (body.size() > *needed && !isPagePadding(body.substr(*needed), header)))
    return wrongLength(path, header, body.size());
  return gather(
      body, header, fields, [&](size_t f) { return offsetInPoint(header, f); },
      [&](size_t) { return header.pointBytes; });
}

Expected<Columns> readCompressed(const std::string& path, std::string_view bytes, const PcdHeader& header,
                                 const std::vector<size_t>& fields) {
  const std::string_view body = bytes.substr(header.bodyOffset);
  const std::string where = "byte " + std::to_string(header.bodyOffset);
  std::uint32_t packedSize = 0;
  std::uint32_t size = 0;
  if (body.size() < sizeof packedSize + sizeof size)
    return Error{path, where, "the file ends before its compressed data", kCutOff};
  std::memcpy(&packedSize, body.data(), sizeof packedSize);
  std::memcpy(&size, body.data() + sizeof packedSize, sizeof size);
  std::string_view packed = body.substr(sizeof packedSize + sizeof size);
  if (packed.size() > packedSize && isPagePadding(packed.substr(packedSize), header))
    packed = packed.substr(0, packedSize);
  if (packed.size() != packedSize)
    return Error{path, where,
                 std::to_string(packedSize) + " compressed bytes are announced, but " +
                     std::to_string(packed.size()) + " follow",
                 kCutOff};
  if (bodyBytes(header) != std::optional<std::uint64_t>(size)) return wrongLength(path, header, size);
  auto unpacked = lzfUnpack(packed, size, header.bodyOffset + 8);
  if (!unpacked) {
    Error error = unpacked.error();
    error.file = path;
    return error;
  }
  // Field by field, each for all points, so that alike bytes stand together.
  return gather(
      *unpacked, header, fields, [&](size_t f) { return header.points * offsetInPoint(header, f); },
      [&](size_t f) { return header.fields[f].size * header.fields[f].count; });
}

Expected<Columns> readAscii(const std::string& path, std::string_view bytes, const PcdHeader& header,
                            const std::vector<size_t>& fields, std::vector<std::string>& notes) {
  const std::string_view body = bytes.substr(header.bodyOffset);
  // A number and its separator take two bytes: so memory stays bounded by the file, whatever the header says.
  if (header.points > (body.size() + 1) / 2 / header.pointNumbers)
    return Error{path, "byte " + std::to_string(header.bodyOffset),
                 "too few rows: " + std::to_string(header.points) + " rows of " +
                     std::to_string(header.pointNumbers) + " numbers do not fit into the " +
                     std::to_string(body.size()) + " bytes after the header",
                 kCutOff};
  Columns columns = emptyColumns(header, fields);
  std::vector<int> columnOfNumber(header.pointNumbers, -1);
  for (size_t c = 0; c < fields.size(); ++c) {
    std::uint64_t position = 0;
    for (size_t f = 0; f < fields[c]; ++f) position += header.fields[f].count;
    columnOfNumber[position] = static_cast<int>(c);
  }

  TextLines lines(body, header.bodyLine);
  std::uint64_t row = 0;
  while (lines.next()) {
    std::string_view rest = lines.line();
    std::string_view token = takeToken(rest);
    if (token.empty()) continue;
    if (row == header.points)
      return Error{path, lines.where(),
                   "more rows than the " + std::to_string(header.points) + " of the header", kCutOff};
    for (std::uint64_t n = 0; n < header.pointNumbers; ++n, token = takeToken(rest)) {
      if (token.empty())
        return Error{path, lines.where(),
                     std::to_string(n) + " numbers instead of " + std::to_string(header.pointNumbers),
                     kCutOff};
      const auto number = numberFromText(token);
      if (!number)
        return Error{path, lines.where(), quotedText(token) + " is not a number",
                     "correct it, or write nan if nothing was measured"};
      if (columnOfNumber[n] >= 0) columns[static_cast<size_t>(columnOfNumber[n])][row] = *number;
    }
    if (!token.empty())
      return Error{path, lines.where(),
                   "more than the " + std::to_string(header.pointNumbers) + " numbers FIELDS announces",
                   kCutOff};
    if (!lines.hasLineEnd()) notes.push_back("The last row has no line end; its last number may be cut off.");
    ++row;
  }
  if (row < header.points)
    return Error{
        path, lines.where(),
        "the file ends after " + std::to_string(row) + " of " + std::to_string(header.points) + " rows",
        kCutOff};
  return columns;
}

const char* formatName(PcdEncoding encoding) {
  switch (encoding) {
    case PcdEncoding::Ascii:
      return "PCD ascii";
    case PcdEncoding::Binary:
      return "PCD binary";
    default:
      return "PCD binary_compressed";
  }
}

}  // namespace

Expected<Columns> readPcdColumns(const std::string& path, std::string_view bytes, const PcdHeader& header,
                                 const std::vector<size_t>& fields, std::vector<std::string>& notes) {
  for (const size_t f : fields)
    require(f < header.fields.size() && header.fields[f].count == 1,
            "readPcdColumns: not a field of one number");
  switch (header.encoding) {
    case PcdEncoding::Ascii:
      return readAscii(path, bytes, header, fields, notes);
    case PcdEncoding::Binary:
      return readBinary(path, bytes, header, fields);
    default:
      return readCompressed(path, bytes, header, fields);
  }
}

Expected<RawCloud> readPcd(const std::string& path, std::string bytes) {
  const auto header = parsePcdHeader(path, bytes);
  if (!header) return header.error();
  RawCloud cloud;
  cloud.format = formatName(header->encoding);
  cloud.scan_T_sensor = header->viewpoint;
  for (const PcdField& field : header->fields) cloud.fields.push_back(field.name);

  std::vector<size_t> wanted;
  for (const char* name : {"x", "y", "z"}) {
    const auto index = header->fieldNamed(name);
    const std::string where = std::string("field ") + name;
    if (!index)
      return Error{path, where, "FIELDS has it not at all or more than once",
                   "a scan needs one x, one y and one z"};
    const PcdField& field = header->fields[*index];
    if (field.type != 'F' || field.count != 1)
      return Error{path, where,
                   std::string("of TYPE ") + field.type + " and COUNT " + std::to_string(field.count),
                   "coordinates must be of TYPE F with SIZE 4 or 8 and COUNT 1"};
    cloud.wideCoordinates |= field.size == 8 || header->encoding == PcdEncoding::Ascii;
    wanted.push_back(*index);
  }
  auto columns = readPcdColumns(path, bytes, *header, wanted, cloud.notes);
  if (!columns) return columns.error();
  bytes = {};  // free the file before the points are laid out

  LocalOrigin origin;
  cloud.points.resize(header->points);
  for (size_t i = 0; i < cloud.points.size(); ++i) {
    const Eigen::Vector3d p((*columns)[0][i], (*columns)[1][i], (*columns)[2][i]);
    for (const double v : p)
      if (isAbsurdCoordinate(v))
        return Error{path, "point " + std::to_string(i), "a coordinate of " + shortestText(v) + " m",
                     "is the file damaged, or in another unit? Coordinates are metres, at most 1e9"};
    cloud.points[i] = cloud.wideCoordinates ? origin.shifted(p)
                      : p.allFinite()       ? Eigen::Vector3f(p.cast<float>())
                                            : Eigen::Vector3f::Constant(kNaNf);
  }
  cloud.localOrigin = origin.origin();
  if (header->height > 1) {
    cloud.lines = static_cast<int>(header->height);
    cloud.beams = static_cast<int>(header->width);
  }
  return cloud;
}

}  // namespace stratascope
