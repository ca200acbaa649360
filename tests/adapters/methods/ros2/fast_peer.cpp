// SPDX-License-Identifier: BSD-3-Clause
// The node of a test on Fast DDS, the default middleware of ROS 2: a second implementation of the
// wire, with types written by hand. Its parameter service is that of rmw_fastrtps.
#include "navigating_node.h"

#include <array>
#include <fastcdr/Cdr.h>
#include <fastdds/dds/core/condition/WaitSet.hpp>
#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/subscriber/DataReader.hpp>
#include <fastdds/dds/subscriber/SampleInfo.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>
#include <fastdds/dds/topic/TopicDataType.hpp>
#include <fastdds/rtps/transport/UDPv4TransportDescriptor.h>
#include <fastrtps/utils/IPLocator.h>
#include <map>
#include <memory>
#include <utility>

namespace {

namespace dds = eprosima::fastdds::dds;
using eprosima::fastcdr::Cdr;
using eprosima::fastrtps::rtps::SerializedPayload_t;
using slalom::NavigatingNode;

struct Time {
  std::int32_t seconds = 0;
  std::uint32_t nanoseconds = 0;
  std::int64_t value() const {
    return seconds * std::int64_t{1'000'000'000} + static_cast<std::int64_t>(nanoseconds);
  }
};

struct Scan {
  Time stamp;
  std::string frame;
  std::array<float, 7> numbers = {};
  std::vector<float> ranges, intensities;
  void code(Cdr& cdr) {
    cdr >> stamp.seconds >> stamp.nanoseconds >> frame >> numbers >> ranges >> intensities;
  }
};
struct Clock {
  Time now;
  void code(Cdr& cdr) { cdr >> now.seconds >> now.nanoseconds; }
};
struct Goal {
  Time stamp;
  std::string frame;
  std::array<double, 7> pose = {};
  void code(Cdr& cdr) { cdr >> stamp.seconds >> stamp.nanoseconds >> frame >> pose; }
};
struct Odometry {
  Time stamp;
  std::string frame, child_frame;
  std::array<double, 7> pose = {};
  std::array<double, 6> velocities = {};
  std::array<double, 36> pose_covariance = {}, covariance = {};
  void code(Cdr& cdr) {
    cdr >> stamp.seconds >> stamp.nanoseconds >> frame >> child_frame >> pose >> pose_covariance >>
        velocities >> covariance;
  }
};
struct Question {
  std::vector<std::string> names;
  void code(Cdr& cdr) { cdr >> names; }
};
struct Twist {
  std::array<double, 6> velocities = {};
  void code(Cdr& cdr) { cdr << velocities; }
};
struct TwistStamped {
  Time stamp;
  std::array<double, 6> velocities = {};
  void code(Cdr& cdr) {
    cdr << stamp.seconds << stamp.nanoseconds << std::string("base_link") << velocities;
  }
};
struct Reply {
  std::vector<std::uint8_t> types;
  void code(Cdr& cdr) { cdr << types; }
};

/// The value of a parameter: a double, as the others of its node.
struct Value {
  std::uint8_t type = 3;
  double number = 0;
  template <typename Field>
  static void code(Cdr& cdr, Field& field, bool writes) {
    if (writes)
      cdr << field;
    else
      cdr >> field;
  }
  void code(Cdr& cdr, bool writes) {
    bool on = false;
    std::int64_t integer = 0;
    std::string text;
    std::uint32_t none = 0;  // the sizes of the arrays
    code(cdr, type, writes);
    code(cdr, on, writes);
    code(cdr, integer, writes);
    code(cdr, number, writes);
    code(cdr, text, writes);
    for (int array = 0; array < 5; ++array) code(cdr, none, writes);
  }
};
struct Values {
  Value value;
  std::size_t count = 0;
  void code(Cdr& cdr) {
    cdr << static_cast<std::uint32_t>(count);
    for (std::size_t i = 0; i < count; ++i) value.code(cdr, true);
  }
};
struct Setting {
  std::string name;
  Value value;
  std::uint32_t count = 0;
  void code(Cdr& cdr) {
    cdr >> count;
    for (std::uint32_t i = 0; i < count; ++i) {
      cdr >> name;
      value.code(cdr, false);
    }
  }
};
struct Result {
  std::string reason;
  std::uint32_t count = 0;
  void code(Cdr& cdr) {
    cdr << count;
    for (std::uint32_t i = 0; i < count; ++i) cdr << reason.empty() << reason;
  }
};

/// Reads or writes a message by its code().
template <typename Message>
class Type : public dds::TopicDataType {
 public:
  explicit Type(const std::string& name) {
    setName(name.c_str());
    m_typeSize = 100'000;
  }
  bool serialize(void* data, SerializedPayload_t* payload) override {
    eprosima::fastcdr::FastBuffer buffer(reinterpret_cast<char*>(payload->data), payload->max_size);
    Cdr cdr(buffer, Cdr::DEFAULT_ENDIAN, Cdr::DDS_CDR);
    payload->encapsulation = cdr.endianness() == Cdr::BIG_ENDIANNESS ? CDR_BE : CDR_LE;
    cdr.serialize_encapsulation();
    static_cast<Message*>(data)->code(cdr);
    payload->length = static_cast<std::uint32_t>(cdr.getSerializedDataLength());
    return true;
  }
  bool deserialize(SerializedPayload_t* payload, void* data) override {
    eprosima::fastcdr::FastBuffer buffer(reinterpret_cast<char*>(payload->data), payload->length);
    Cdr cdr(buffer, Cdr::DEFAULT_ENDIAN, Cdr::DDS_CDR);
    cdr.read_encapsulation();
    static_cast<Message*>(data)->code(cdr);
    return true;
  }
  std::function<std::uint32_t()> getSerializedSizeProvider(void*) override {
    return [this] { return m_typeSize; };
  }
  void* createData() override { return new Message; }
  void deleteData(void* data) override { delete static_cast<Message*>(data); }
  bool getKey(void*, eprosima::fastrtps::rtps::InstanceHandle_t*, bool) override { return false; }
};

class Peer {
 public:
  Peer(int argc, char** argv)
      : node_(argc, argv, [this](const NavigatingNode::Answer& answer) { publish(answer); }) {
    participant_ = make_participant();
    publisher_ = participant_->create_publisher(dds::PUBLISHER_QOS_DEFAULT);
    subscriber_ = participant_->create_subscriber(dds::SUBSCRIBER_QOS_DEFAULT);
    clock_ = reader<Clock>("rt/clock", "rosgraph_msgs::msg::dds_::Clock_");
    goal_ = reader<Goal>("rt/goal_pose", "geometry_msgs::msg::dds_::PoseStamped_");
    odometry_ = reader<Odometry>("rt/odom", "nav_msgs::msg::dds_::Odometry_");
    scan_ = reader<Scan>("rt/scan", "sensor_msgs::msg::dds_::LaserScan_");
    question_ = reader<Question>("rq/method/get_parameter_typesRequest",
                                 "rcl_interfaces::srv::dds_::GetParameterTypes_Request_");
    reply_ = writer<Reply>("rr/method/get_parameter_typesReply",
                           "rcl_interfaces::srv::dds_::GetParameterTypes_Response_");
    get_ = reader<Question>("rq/method/get_parametersRequest",
                            "rcl_interfaces::srv::dds_::GetParameters_Request_");
    values_ = writer<Values>("rr/method/get_parametersReply",
                             "rcl_interfaces::srv::dds_::GetParameters_Response_");
    set_ = reader<Setting>("rq/method/set_parametersRequest",
                           "rcl_interfaces::srv::dds_::SetParameters_Request_");
    result_ = writer<Result>("rr/method/set_parametersReply",
                             "rcl_interfaces::srv::dds_::SetParameters_Response_");
    command_ = node_.stamped()
                   ? writer<TwistStamped>("rt/cmd_vel", "geometry_msgs::msg::dds_::TwistStamped_")
                   : writer<Twist>("rt/cmd_vel", "geometry_msgs::msg::dds_::Twist_");
  }

  void spin() {
    for (;;) {
      dds::ConditionSeq active;
      waitset_.wait(active, eprosima::fastrtps::c_TimeInfinite);
      take<Clock>(clock_, [this](const Clock& m) { node_.on_clock(m.now.value()); });
      take<Goal>(goal_, [this](const Goal& m) { node_.on_goal(m.pose[1]); });
      take<Odometry>(odometry_, [this](const Odometry& m) { node_.on_odometry(m.velocities[0]); });
      take<Scan>(scan_, [this](const Scan& m) {
        node_.on_scan(m.stamp.value(), m.ranges, m.numbers[0], m.numbers[2]);
      });
      take_one<Question>(question_, [this](const Question& m) {
        constexpr std::uint8_t kBool = 1;  // the type of use_sim_time
        answer(reply_, Reply{std::vector<std::uint8_t>(m.names.size(), kBool)});
      });
      take_one<Question>(get_, [this](const Question& m) {
        answer(values_, Values{{3, node_.speed()}, m.names.size()});
      });
      take_one<Setting>(set_, [this](const Setting& m) {
        answer(result_, Result{node_.set_speed(m.value.number), m.count});
      });
    }
  }

 private:
  /// Found by unicast on this machine, as with ROS_AUTOMATIC_DISCOVERY_RANGE=LOCALHOST; of Humble
  /// bound to the loopback device, as with ROS_LOCALHOST_ONLY=1.
  dds::DomainParticipant* make_participant() const {
    const char* domain = std::getenv("ROS_DOMAIN_ID");
    const int id = domain == nullptr ? 0 : std::atoi(domain);
    dds::DomainParticipantQos qos;
    qos.transport().use_builtin_transports = false;
    const auto transport = std::make_shared<eprosima::fastdds::rtps::UDPv4TransportDescriptor>();
    const bool is_bound = node_.fault() == "humble";
    if (is_bound) transport->interfaceWhiteList.emplace_back("127.0.0.1");
    qos.transport().user_transports.push_back(transport);
    for (int index = 0; index < 10 && !is_bound; ++index) {
      eprosima::fastrtps::rtps::Locator_t locator;
      eprosima::fastrtps::rtps::IPLocator::setIPv4(locator, 127, 0, 0, 1);
      locator.port = static_cast<std::uint32_t>(7410 + 250 * id + 2 * index);
      qos.wire_protocol().builtin.initialPeersList.push_back(locator);
    }
    return dds::DomainParticipantFactory::get_instance()->create_participant(
        static_cast<std::uint32_t>(id), qos);
  }

  template <typename Message>
  dds::Topic* topic(const char* name, const char* type) {
    dds::TypeSupport(new Type<Message>(type)).register_type(participant_);
    return participant_->create_topic(name, type, dds::TOPIC_QOS_DEFAULT);
  }

  template <typename Message>
  dds::DataReader* reader(const char* name, const char* type) {
    dds::DataReaderQos qos;
    qos.reliability().kind = dds::RELIABLE_RELIABILITY_QOS;
    auto* made = subscriber_->create_datareader(topic<Message>(name, type), qos);
    made->get_statuscondition().set_enabled_statuses(dds::StatusMask::data_available());
    waitset_.attach_condition(made->get_statuscondition());
    return made;
  }

  template <typename Message>
  dds::DataWriter* writer(const char* name, const char* type) {
    dds::DataWriterQos qos;
    qos.reliability().kind = dds::RELIABLE_RELIABILITY_QOS;
    qos.publish_mode().kind = dds::SYNCHRONOUS_PUBLISH_MODE;
    return publisher_->create_datawriter(topic<Message>(name, type), qos);
  }

  /// Whether there was one. Questions are taken one in a turn, as in rclcpp: data that are there
  /// before a question are handled before it.
  template <typename Message, typename Function>
  static bool take_one(dds::DataReader* reader, Function function) {
    Message message;
    dds::SampleInfo info;
    if (reader->take_next_sample(&message, &info) != ReturnCode_t::RETCODE_OK) return false;
    if (info.valid_data) function(message);
    return true;
  }
  template <typename Message, typename Function>
  static void take(dds::DataReader* reader, Function function) {
    while (take_one<Message>(reader, function)) {
    }
  }

  /// With the fault "late", the first reply of a service waits until a second one is there.
  template <typename Message>
  void answer(dds::DataWriter* replies, Message message) {
    const bool is_late = node_.fault() == "late";
    if (is_late && late_.count(replies) == 0) {
      late_[replies] = [replies, message]() mutable { replies->write(&message); };
      return;
    }
    if (is_late) std::exchange(late_[replies], [] {})();
    replies->write(&message);
  }

  void publish(const NavigatingNode::Answer& answer) {
    const std::array<double, 6> velocities = {answer.velocity.v, 0, 0, 0, 0, answer.velocity.w};
    if (node_.stamped()) {
      TwistStamped message{{static_cast<std::int32_t>(answer.stamp / 1'000'000'000),
                            static_cast<std::uint32_t>(answer.stamp % 1'000'000'000)},
                           velocities};
      command_->write(&message);
    } else {
      Twist message{velocities};
      command_->write(&message);
    }
  }

  NavigatingNode node_;
  dds::WaitSet waitset_;
  dds::DomainParticipant* participant_ = nullptr;
  dds::Publisher* publisher_ = nullptr;
  dds::Subscriber* subscriber_ = nullptr;
  dds::DataReader *clock_ = nullptr, *goal_ = nullptr, *odometry_ = nullptr, *scan_ = nullptr,
                  *question_ = nullptr, *get_ = nullptr, *set_ = nullptr;
  std::map<dds::DataWriter*, std::function<void()>> late_;
  dds::DataWriter *reply_ = nullptr, *values_ = nullptr, *result_ = nullptr, *command_ = nullptr;
};

}  // namespace

int main(int argc, char** argv) {
  Peer(argc, argv).spin();
}
