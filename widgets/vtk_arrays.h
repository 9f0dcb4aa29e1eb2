// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkSmartPointer.h>
#include <vtkTypeInt32Array.h>
#include <vtkUnsignedCharArray.h>

#include <cstdint>
#include <vector>

namespace stratascope {

/// VTK arrays laid over vectors without a copy. The vectors must outlive the arrays; VTK only reads them.
inline vtkSmartPointer<vtkFloatArray> floatsOver(const float* values, size_t count) {
  auto array = vtkSmartPointer<vtkFloatArray>::New();
  array->SetNumberOfComponents(3);
  array->SetArray(const_cast<float*>(values), static_cast<vtkIdType>(count), 1);
  return array;
}

inline vtkSmartPointer<vtkUnsignedCharArray> bytesOver(const std::uint8_t* values, size_t count) {
  auto array = vtkSmartPointer<vtkUnsignedCharArray>::New();
  array->SetName("colour");
  array->SetNumberOfComponents(3);
  array->SetArray(const_cast<std::uint8_t*>(values), static_cast<vtkIdType>(count), 1);
  return array;
}

inline vtkSmartPointer<vtkTypeInt32Array> intsOver(const std::vector<std::int32_t>& values) {
  auto array = vtkSmartPointer<vtkTypeInt32Array>::New();
  array->SetArray(const_cast<std::int32_t*>(values.data()), static_cast<vtkIdType>(values.size()), 1);
  return array;
}

/// One cell that holds the first `count` of these points: how a cloud is drawn fastest.
inline vtkSmartPointer<vtkCellArray> polyVertex(const std::vector<std::int32_t>& points, size_t count) {
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  if (count == 0) return cells;
  auto offsets = vtkSmartPointer<vtkTypeInt32Array>::New();
  offsets->InsertNextValue(0);
  offsets->InsertNextValue(static_cast<std::int32_t>(count));
  auto corners = vtkSmartPointer<vtkTypeInt32Array>::New();
  corners->SetArray(const_cast<std::int32_t*>(points.data()), static_cast<vtkIdType>(count), 1);
  cells->SetData(offsets, corners);
  return cells;
}

}  // namespace stratascope
