// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/bags/topic_choice.h>
#include <slalom/core/printable.h>
#include <slalom/core/text.h>

#include <algorithm>

namespace slalom {

bool TopicChoice::takes(const BagTopic& topic) {
  if (!contains(types_, topic.type)) return false;
  if (!wanted_.empty() && topic.name != wanted_) return false;
  if (!contains(fitting_, topic.name)) fitting_.push_back(topic.name);
  return topic.name == fitting_.front();
}

const std::string& TopicChoice::name() const {
  static const std::string kNone;
  return fitting_.empty() ? kNone : fitting_.front();
}

void TopicChoice::check(const std::string& path, const std::vector<BagTopic>& topics) const {
  if (fitting_.size() > 1)
    throw file_error(path,
                     "has several topics of type " + join(types_, " or ") + ": " +
                         printable_line(join(fitting_, ", ")),
                     option_ + " with one of them");
  if (wanted_.empty() || !fitting_.empty()) return;
  std::vector<std::string> names;
  for (const BagTopic& topic : topics) {
    if (topic.name == wanted_)
      throw file_error(
          path,
          "'" + wanted_ + "' " +
              (contains(types_, topic.type) ? "has no message"
                                            : "is of type " + printable_line(topic.type)),
          "a topic of type " + join(types_, " or "));
    if (contains(types_, topic.type)) names.push_back(printable_line(topic.name));
  }
  throw file_error(
      path, "has no topic '" + wanted_ + "'",
      names.empty() ? "a bag with " + join(types_, " or ") : expected_name(wanted_, names));
}

}  // namespace slalom
