// SPDX-License-Identifier: BSD-3-Clause
// The node of a test on Cyclone DDS, with the topics and the parameter service of a node of rclcpp
// under rmw_cyclonedds; single-threaded, with the order of rclcpp's executor: timers,
// subscriptions, services.
#include "navigating_node.h"
#include "ros2_messages.h"

#include <cstring>
#include <dds/dds.h>
#include <fstream>
#include <type_traits>
#include <utility>

namespace {

using slalom::NavigatingNode;

/// The settings by ROS_AUTOMATIC_DISCOVERY_RANGE=LOCALHOST of Iron and later.
constexpr char kLocalHost[] =
    "<CycloneDDS><Domain Id=\"any\"><General><AllowMulticast>false</AllowMulticast></General>"
    "<Discovery><ParticipantIndex>auto</ParticipantIndex>"
    "<MaxAutoParticipantIndex>32</MaxAutoParticipantIndex>"
    "<Peers><Peer address=\"127.0.0.1\"/></Peers></Discovery></Domain></CycloneDDS>";

/// The settings by ROS_LOCALHOST_ONLY=1 of Humble.
constexpr char kLoopback[] =
    "<CycloneDDS><Domain Id=\"any\"><General><Interfaces>"
    "<NetworkInterface address=\"127.0.0.1\"/></Interfaces></General></Domain></CycloneDDS>";

std::int64_t nanoseconds(const builtin_interfaces_msg_dds__Time_& time) {
  return time.sec * std::int64_t{1'000'000'000} + static_cast<std::int64_t>(time.nanosec);
}

class Peer {
 public:
  Peer(int argc, char** argv)
      : node_(argc, argv, [this](const NavigatingNode::Answer& answer) { publish(answer); }) {
    const char* domain = std::getenv("ROS_DOMAIN_ID");
    domain_ = static_cast<dds_domainid_t>(domain == nullptr ? 0 : std::atoi(domain));
    dds_create_domain(domain_, node_.fault() == "humble" ? kLoopback : kLocalHost);
    participant_ = dds_create_participant(domain_, nullptr, nullptr);
    waitset_ = dds_create_waitset(participant_);
    clock_ = reader("rt/clock", rosgraph_msgs_msg_dds__Clock__desc, false);
    goal_ = reader("rt/goal_pose", geometry_msgs_msg_dds__PoseStamped__desc, true);
    odometry_ = reader("rt/odom", nav_msgs_msg_dds__Odometry__desc, true);
    read_scans();
    if (node_.fault() == "humble") {
      // A costmap reads scans while it is configured, and again when it has the robot's pose.
      dds_delete(std::exchange(scan_, 0));
      pose_ = reader("rt/tf", tf2_msgs_msg_dds__TFMessage__desc, true);
    }
    if (const char* path = std::getenv("TRANSFORMS_FILE")) {
      transforms_path_ = path;
      transforms_ = reader("rt/tf_static", tf2_msgs_msg_dds__TFMessage__desc, true, true);
    }
    types_ = service("get_parameter_types", "GetParameterTypes", slalom_ros2_CycloneNames_desc,
                     slalom_ros2_CycloneTypes_desc);
    values_ = service("get_parameters", "GetParameters", slalom_ros2_CycloneNames_desc,
                      slalom_ros2_CycloneValues_desc);
    setting_ = service("set_parameters", "SetParameters", slalom_ros2_CycloneParameters_desc,
                       slalom_ros2_CycloneResults_desc);
    command_ = writer("rt/cmd_vel", node_.fault() == "wrong_type"
                                        ? geometry_msgs_msg_dds__PoseStamped__desc
                                    : node_.stamped() ? geometry_msgs_msg_dds__TwistStamped__desc
                                                      : geometry_msgs_msg_dds__Twist__desc);
    if (node_.fault() == "humble") {
      // The velocity smoother, and a server of behaviors with a publisher each.
      std::vector<dds_entity_t> behaviors(5);
      for (dds_entity_t& one : behaviors)
        one = writer("rt/cmd_vel", geometry_msgs_msg_dds__Twist__desc);
      announce<slalom_ros2_ParticipantOfHumble>(
          slalom_ros2_ParticipantOfHumble_desc, "",
          {{"velocity_smoother", {command_}}, {"behavior_server", behaviors}});
    } else if (node_.fault() == "jazzy") {
      announce<slalom_ros2_Participant>(slalom_ros2_Participant_desc, "typehash=RIHS01_0;",
                                        {{"collision_monitor", {command_}}});
    }
  }

  void spin() {
    for (;;) {
      dds_attach_t hit = 0;
      dds_waitset_wait(waitset_, &hit, 1, DDS_INFINITY);
      take<rosgraph_msgs_msg_dds__Clock_>(
          clock_, [this](const auto& m) { node_.on_clock(nanoseconds(m.clock)); });
      take<geometry_msgs_msg_dds__PoseStamped_>(
          goal_, [this](const auto& m) { node_.on_goal(m.pose.position.y); });
      if (node_.uses_odometry()) take_scans();
      take<nav_msgs_msg_dds__Odometry_>(
          odometry_, [this](const auto& m) { node_.on_odometry(m.twist.twist.linear.x); });
      if (pose_ > 0)
        take<tf2_msgs_msg_dds__TFMessage_>(pose_, [this](const auto&) {
          if (scan_ == 0) read_scans();
        });
      if (transforms_ > 0)
        take<tf2_msgs_msg_dds__TFMessage_>(transforms_, [this](const auto& m) { keep(m); });
      take_scans();
      take_one<slalom_ros2_CycloneNames>(types_.question, [this](const auto& m) {
        if (node_.fault() == "deaf" && node_.has_fault_now()) return;
        if (loses(types_)) return;
        // The replies to two questions with one number could not be told apart.
        if (m.number <= last_question_) std::exit(4);
        last_question_ = m.number;
        const slalom_ros2_CycloneTypes reply{m.client, m.number, {}};
        dds_write(types_.reply, &reply);
      });
      take_one<slalom_ros2_CycloneNames>(values_.question, [this](const auto& m) {
        if (!loses(values_)) get(m);
      });
      take_one<slalom_ros2_CycloneParameters>(setting_.question, [this](const auto& m) {
        if (!loses(setting_)) set(m);
      });
    }
  }

 private:
  void read_scans() { scan_ = reader("rt/scan", sensor_msgs_msg_dds__LaserScan__desc, false); }

  void take_scans() {
    if (scan_ == 0) return;
    take<sensor_msgs_msg_dds__LaserScan_>(scan_, [this](const auto& m) {
      const float* first = m.ranges._buffer;
      node_.on_scan(nanoseconds(m.header.stamp), {first, first + m.ranges._length}, m.angle_min,
                    m.angle_increment);
      if (node_.fault() == "two" && node_.has_fault_now() && second_ == 0) publish_twice();
    });
  }

  /// Announces the nodes and their publishers of commands, as rmw does.
  template <typename Participant>
  void announce(dds_topic_descriptor_t type, const std::string& user_data,
                const std::vector<std::pair<std::string, std::vector<dds_entity_t>>>& named) const {
    using Node = std::remove_pointer_t<decltype(Participant::nodes._buffer)>;
    using Identifier = std::remove_pointer_t<decltype(Node::writers._buffer)>;
    type.m_typename = "rmw_dds_common::msg::dds_::ParticipantEntitiesInfo_";
    dds_qos_t* qos = dds_create_qos();
    dds_qset_durability(qos, DDS_DURABILITY_TRANSIENT_LOCAL);
    dds_qset_reliability(qos, DDS_RELIABILITY_RELIABLE, DDS_SECS(1));
    if (!user_data.empty()) dds_qset_userdata(qos, user_data.data(), user_data.size());
    const auto out =
        dds_create_writer(participant_, topic("ros_discovery_info", type), qos, nullptr);
    dds_delete_qos(qos);
    std::vector<std::vector<Identifier>> identifiers;
    std::vector<Node> nodes;
    for (const auto& [name, writers] : named) {
      identifiers.emplace_back();
      for (const dds_entity_t writer : writers) {
        dds_guid_t guid;
        dds_get_guid(writer, &guid);
        identifiers.back().emplace_back();
        std::memcpy(identifiers.back().back().data, guid.v, sizeof guid.v);
      }
    }
    for (std::size_t i = 0; i < named.size(); ++i) {
      nodes.emplace_back();
      nodes.back().name_space = const_cast<char*>("/");
      nodes.back().name = const_cast<char*>(named[i].first.c_str());
      nodes.back().writers._buffer = identifiers[i].data();
      nodes.back().writers._length = nodes.back().writers._maximum =
          static_cast<std::uint32_t>(identifiers[i].size());
    }
    Participant message{};
    message.nodes._buffer = nodes.data();
    message.nodes._length = message.nodes._maximum = static_cast<std::uint32_t>(nodes.size());
    dds_write(out, &message);
  }

  struct Service {
    dds_entity_t question = 0, reply = 0;
    bool has_lost = false;
  };

  /// Whether the reply to the first question is lost.
  bool loses(Service& service) const {
    return node_.fault() == "loses" && !std::exchange(service.has_lost, true);
  }

  Service service(const std::string& name, const std::string& type, dds_topic_descriptor_t question,
                  dds_topic_descriptor_t reply) const {
    const std::string prefix = "rcl_interfaces::srv::dds_::" + type;
    const std::string request_type = prefix + "_Request_", reply_type = prefix + "_Response_";
    question.m_typename = request_type.c_str();
    reply.m_typename = reply_type.c_str();
    return {reader(("rq/method/" + name + "Request").c_str(), question, true),
            writer(("rr/method/" + name + "Reply").c_str(), reply), false};
  }

  /// Replies with values of several types; a name that is not there has none, as in rclpy.
  void get(const slalom_ros2_CycloneNames& question) {
    slalom_ros2_ParameterValue value{};
    const std::string name = question.body.names._buffer[0];
    if (name == "speed") {
      value.type = 3;
      value.double_value = node_.speed();
    } else if (name == "count") {
      value.type = 2;
      value.integer_value = count_;
    } else if (name == "on") {
      value.type = 1;
      value.bool_value = on_;
    } else if (name == "label") {
      value.type = 4;
      value.string_value = label_.data();
    } else if (name == "list") {
      value.type = 8;
    }
    slalom_ros2_CycloneValues reply{question.client, question.number, {}};
    reply.body.values._buffer = &value;
    reply.body.values._length = reply.body.values._maximum = 1;
    dds_write(values_.reply, &reply);
  }

  void set(const slalom_ros2_CycloneParameters& question) {
    const slalom_ros2_Parameter& one = question.body.parameters._buffer[0];
    const std::string name = one.name;
    std::string reason;
    if (name == "speed") reason = node_.set_speed(one.value.double_value);
    if (name == "count") count_ = one.value.integer_value;
    if (name == "on") on_ = one.value.bool_value;
    if (name == "label") label_ = one.value.string_value;
    slalom_ros2_Result result{reason.empty(), reason.data()};
    slalom_ros2_CycloneResults reply{question.client, question.number, {}};
    reply.body.results._buffer = &result;
    reply.body.results._length = reply.body.results._maximum = 1;
    dds_write(setting_.reply, &reply);
  }

  dds_entity_t topic(const char* name, const dds_topic_descriptor_t& type) const {
    return dds_create_topic(participant_, &type, name, nullptr, nullptr);
  }

  dds_entity_t reader(const char* name, const dds_topic_descriptor_t& type, bool reliable,
                      bool latched = false) const {
    dds_qos_t* qos = dds_create_qos();
    if (latched) dds_qset_durability(qos, DDS_DURABILITY_TRANSIENT_LOCAL);
    dds_qset_reliability(qos, reliable ? DDS_RELIABILITY_RELIABLE : DDS_RELIABILITY_BEST_EFFORT,
                         DDS_SECS(1));
    const auto made = dds_create_reader(participant_, topic(name, type), qos, nullptr);
    dds_delete_qos(qos);
    dds_set_status_mask(made, DDS_DATA_AVAILABLE_STATUS);
    dds_waitset_attach(waitset_, made, 0);
    return made;
  }

  dds_entity_t writer(const char* name, const dds_topic_descriptor_t& type) const {
    dds_qos_t* qos = dds_create_qos();
    dds_qset_reliability(
        qos,
        node_.fault() == "best_effort" ? DDS_RELIABILITY_BEST_EFFORT : DDS_RELIABILITY_RELIABLE,
        DDS_SECS(1));
    const auto made = dds_create_writer(participant_, topic(name, type), qos, nullptr);
    dds_delete_qos(qos);
    return made;
  }

  /// A line for each transform: frames, x, y, z, quaternion x, y, z, w.
  void keep(const tf2_msgs_msg_dds__TFMessage_& message) const {
    std::ofstream file(transforms_path_);
    for (std::uint32_t i = 0; i < message.transforms._length; ++i) {
      const auto& one = message.transforms._buffer[i];
      const auto& [translation, rotation] = one.transform;
      file << one.header.frame_id << " " << one.child_frame_id << " " << translation.x << " "
           << translation.y << " " << translation.z << " " << rotation.x << " " << rotation.y << " "
           << rotation.z << " " << rotation.w << "\n";
    }
  }

  /// Returns when the simulator has found the second publisher, in another participant.
  void publish_twice() {
    const dds_entity_t own = participant_;
    participant_ = dds_create_participant(domain_, nullptr, nullptr);
    second_ = writer("rt/cmd_vel", geometry_msgs_msg_dds__Twist__desc);
    const geometry_msgs_msg_dds__Twist_ twist{};
    dds_write(second_, &twist);
    dds_wait_for_acks(second_, DDS_INFINITY);
    participant_ = own;
  }

  /// Whether there was one. Questions are taken one in a turn, as in rclcpp: data that are there
  /// before a question are handled before it.
  template <typename Message, typename Function>
  static bool take_one(dds_entity_t reader, Function function) {
    void* sample = nullptr;
    dds_sample_info_t info;
    if (dds_take(reader, &sample, &info, 1, 1) <= 0) return false;
    if (info.valid_data) function(*static_cast<const Message*>(sample));
    dds_return_loan(reader, &sample, 1);
    return true;
  }
  template <typename Message, typename Function>
  static void take(dds_entity_t reader, Function function) {
    while (take_one<Message>(reader, function)) {
    }
  }

  void publish(const NavigatingNode::Answer& answer) const {
    geometry_msgs_msg_dds__Twist_ twist{};
    twist.linear.x = answer.velocity.v;
    twist.angular.z = answer.velocity.w;
    if (!node_.stamped()) {
      dds_write(command_, &twist);
      return;
    }
    geometry_msgs_msg_dds__TwistStamped_ message{};
    message.header.stamp = {static_cast<std::int32_t>(answer.stamp / 1'000'000'000),
                            static_cast<std::uint32_t>(answer.stamp % 1'000'000'000)};
    std::string frame(answer.padding, 'x');
    message.header.frame_id = frame.data();
    message.twist = twist;
    dds_write(command_, &message);
  }

  NavigatingNode node_;
  std::int64_t last_question_ = 0;
  std::string transforms_path_;
  dds_domainid_t domain_ = 0;
  dds_entity_t transforms_ = 0, pose_ = 0;
  dds_entity_t participant_ = 0, waitset_ = 0, clock_ = 0, goal_ = 0, odometry_ = 0, scan_ = 0;
  dds_entity_t command_ = 0, second_ = 0;
  Service types_, values_, setting_;
  std::int64_t count_ = 2;
  bool on_ = false;
  std::string label_ = "plain";
};

}  // namespace

int main(int argc, char** argv) {
  Peer(argc, argv).spin();
}
