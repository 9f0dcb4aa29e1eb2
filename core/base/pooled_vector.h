// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <new>
#include <utility>
#include <vector>

#include "base/block_pool.h"

namespace stratascope {

/// Leaves what it is not given a value for unset.
template <class T>
struct UnsetAllocator : PoolAllocator<T> {
  using PoolAllocator<T>::PoolAllocator;
  template <class U>
  struct rebind {
    using other = UnsetAllocator<U>;
  };
  template <class U, class... Arguments>
  void construct(U* at, Arguments&&... arguments) {
    if constexpr (sizeof...(Arguments) == 0)
      ::new (static_cast<void*>(at)) U;
    else
      ::new (static_cast<void*>(at)) U(std::forward<Arguments>(arguments)...);
  }
};

/// For products as large as the scan, written whole: resize() leaves new values unset.
template <class T>
using PooledVector = std::vector<T, UnsetAllocator<T>>;

}  // namespace stratascope
