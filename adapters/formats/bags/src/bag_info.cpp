// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/bags/bag_info.h>
#include <slalom/core/text.h>

#include <algorithm>
#include <tuple>

namespace slalom {
namespace {

class InfoReader {
 public:
  void add(const BagMessage& message) {
    BagTopicInfo& topic = find(message.topic);
    ++topic.messages;
    info_.first = info_.messages == 0 ? message.time : std::min(info_.first, message.time);
    info_.last = info_.messages == 0 ? message.time : std::max(info_.last, message.time);
    ++info_.messages;
    if (is_one_of(kTransformTypes, message.topic.type))
      for (const RosTransform& transform : decode_transforms(message)) info_.frames.add(transform);
    const auto header = decode_header(message);
    if (!header) return;
    info_.first_stamp = std::min(info_.first_stamp.value_or(header->stamp), header->stamp);
    info_.last_stamp = std::max(info_.last_stamp.value_or(header->stamp), header->stamp);
    if (!contains(topic.frames, header->frame)) topic.frames.push_back(header->frame);
  }

  BagInfo info(const std::vector<BagTopic>& topics) && {
    for (const BagTopic& topic : topics) find(topic);
    std::sort(info_.topics.begin(), info_.topics.end(), [](const auto& a, const auto& b) {
      return std::tie(a.topic.name, a.topic.type) < std::tie(b.topic.name, b.topic.type);
    });
    return std::move(info_);
  }

 private:
  BagTopicInfo& find(const BagTopic& topic) {
    for (BagTopicInfo& known : info_.topics)
      if (known.topic.name == topic.name && known.topic.type == topic.type) return known;
    info_.topics.push_back({topic, 0, {}});
    return info_.topics.back();
  }

  BagInfo info_;
};

}  // namespace

double BagInfo::duration() const {
  return 1e-9 * (static_cast<double>(last) - static_cast<double>(first));
}

BagInfo read_bag_info(const std::string& path) {
  InfoReader reader;
  const auto topics = read_bag(path, [&](const BagMessage& message) { reader.add(message); });
  BagInfo info = std::move(reader).info(topics);
  info.file = path;
  info.format = bag_format(path);
  return info;
}

}  // namespace slalom
