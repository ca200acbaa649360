#pragma once

#include <mrpt/serialization/CSerializable.h>

#include <string>
#include <vector>

namespace slalom {

/// The objects of a rawlog in file order, those of a CRawlog object among them. Throws Error (File)
/// with file and reason when it is missing, damaged or cut off.
std::vector<mrpt::serialization::CSerializable::Ptr> read_objects(const std::string& path);

}  // namespace slalom
