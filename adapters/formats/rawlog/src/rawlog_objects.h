// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/serialization/CSerializable.h>

#include <string>
#include <vector>

namespace slalom {

/// The objects of a rawlog in file order, including those within CRawlog objects. Throws Error
/// (File) with file and reason if it is missing, corrupt or truncated.
std::vector<mrpt::serialization::CSerializable::Ptr> read_objects(const std::string& path);

}  // namespace slalom
