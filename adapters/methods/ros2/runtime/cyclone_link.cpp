// SPDX-License-Identifier: BSD-3-Clause
// The topics of ROS 2 on Cyclone DDS, in a library of its own that is loaded when a campaign has a
// method of ROS 2. Names, types and encodings are those of rmw_cyclonedds and rmw_fastrtps.
#include "../src/ros2_link.h"
#include "ros2_messages.h"

#include <slalom/core/math.h>
#include <slalom/core/text.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstring>
#include <dds/dds.h>
#include <ifaddrs.h>
#include <limits>
#include <map>
#include <net/if.h>
#include <set>

namespace slalom {
namespace {

/// Whether the machine has another network interface than the loopback device.
bool has_other_interface() {
  ifaddrs* first = nullptr;
  if (getifaddrs(&first) != 0) return false;
  bool found = false;
  for (const ifaddrs* one = first; one != nullptr; one = one->ifa_next)
    found = found || (one->ifa_addr != nullptr && one->ifa_addr->sa_family == AF_INET &&
                      (one->ifa_flags & IFF_UP) != 0 && (one->ifa_flags & IFF_LOOPBACK) == 0);
  freeifaddrs(first);
  return found;
}

/// The settings of rmw_cyclonedds with ROS_AUTOMATIC_DISCOVERY_RANGE=LOCALHOST, which nodes since
/// Iron have: the interface is chosen by Cyclone. Those of Humble are bound to the loopback device
/// (ROS_LOCALHOST_ONLY), which is therefore the second one; they wait for the next announcement, or
/// for one at the port of multicast.
std::string local_host(int domain) {
  const std::string interfaces = has_other_interface()
                                     ? "<Interfaces><NetworkInterface autodetermine=\"true\"/>"
                                       "<NetworkInterface address=\"127.0.0.1\"/></Interfaces>"
                                     : "";
  constexpr int kFirstPort = 7400, kPortsOfDomain = 250;
  const std::string port = std::to_string(kFirstPort + kPortsOfDomain * domain);
  return "<CycloneDDS><Domain Id=\"any\"><General><AllowMulticast>false</AllowMulticast>" +
         interfaces +
         "</General><Discovery><SPDPInterval>200 ms</SPDPInterval>"
         // Nodes take the first free indices, and may not see that one is taken.
         "<ParticipantIndex>31</ParticipantIndex>"
         "<MaxAutoParticipantIndex>32</MaxAutoParticipantIndex>"
         "<Peers><Peer address=\"127.0.0.1\"/><Peer address=\"127.0.0.1:" +
         port +
         "\"/></Peers></Discovery>"
         // Data of a run that has ended need not be acknowledged.
         "<Internal><WriterLingerDuration>0 s</WriterLingerDuration></Internal>"
         "</Domain></CycloneDDS>";
}

constexpr int kDepth = 10;
constexpr double kMapTime = 10;  // s, wall-clock time until all readers have the map

/// A type of messages with the hash that nodes since Iron announce and expect (REP 2016).
struct Type {
  const dds_topic_descriptor_t* descriptor;
  const char* hash;
};
const Type kClock = {&rosgraph_msgs_msg_dds__Clock__desc,
                     "692f7a66e93a3c83e71765d033b60349ba68023a8c689a79e48078bcb5c58564"};
const Type kOdometry = {&nav_msgs_msg_dds__Odometry__desc,
                        "3cc97dc7fb7502f8714462c526d369e35b603cfc34d946e3f2eda2766dfec6e0"};
const Type kTransforms = {&tf2_msgs_msg_dds__TFMessage__desc,
                          "e369d0f05a23ae52508854b66f6aa0437f3449d652e8cbf22d5abe85d020f087"};
const Type kScan = {&sensor_msgs_msg_dds__LaserScan__desc,
                    "64c191398013af96509d518dac71d5164f9382553fce5c1f8cca5be7924bd828"};
const Type kPose = {&geometry_msgs_msg_dds__PoseStamped__desc,
                    "10f3786d7d40fd2b54367835614bff85d4ad3b5dab62bf8bca0cc232d73b4cd8"};
const Type kGrid = {&nav_msgs_msg_dds__OccupancyGrid__desc,
                    "8d348150c12913a31ee0ec170fbf25089e4745d17035792a1ba94d6f0bc0cfc7"};
const Type kTwist = {&geometry_msgs_msg_dds__Twist__desc,
                     "9c45bf16fe0983d80e3cfe750d6835843d265a9a6c46bd2e609fcddde6fb8d2a"};
const Type kTwistStamped = {&geometry_msgs_msg_dds__TwistStamped__desc,
                            "5f0fcd4f81d5d06ad9b4c4c63e3ea51b82d6ae4d0558f1d475229b1121db6f64"};

dds_entity_t check(const std::string& what, dds_entity_t entity) {
  if (entity < 0) throw MethodError("DDS: " + what + ": " + dds_strretcode(-entity));
  return entity;
}

/// An entity of DDS and all that belongs to it.
class Entity {
 public:
  Entity() = default;
  Entity(const std::string& what, dds_entity_t entity) : entity_(check(what, entity)) {}
  Entity(Entity&& other) noexcept : entity_(std::exchange(other.entity_, 0)) {}
  Entity& operator=(Entity&& other) noexcept {
    std::swap(entity_, other.entity_);
    return *this;
  }
  ~Entity() {
    if (entity_ > 0) dds_delete(entity_);
  }
  operator dds_entity_t() const { return entity_; }  // as the functions of DDS expect

 private:
  dds_entity_t entity_ = 0;
};

using Qos = std::unique_ptr<dds_qos_t, decltype(&dds_delete_qos)>;

Qos make_qos(bool reliable, bool latched, const char* hash) {
  Qos qos(dds_create_qos(), dds_delete_qos);
  dds_qset_reliability(qos.get(), reliable ? DDS_RELIABILITY_RELIABLE : DDS_RELIABILITY_BEST_EFFORT,
                       DDS_SECS(1));
  dds_qset_history(qos.get(), DDS_HISTORY_KEEP_LAST, latched ? 1 : kDepth);
  if (latched) dds_qset_durability(qos.get(), DDS_DURABILITY_TRANSIENT_LOCAL);
  if (hash != nullptr) {
    const std::string text = std::string("typehash=RIHS01_") + hash + ";";
    dds_qset_userdata(qos.get(), text.data(), text.size());
  }
  return qos;
}

/// Takes all that a reader has, one sample after another.
template <typename Message, typename Function>
void take_all(dds_entity_t reader, Function function) {
  for (;;) {
    void* sample = nullptr;
    dds_sample_info_t info;
    const auto count = dds_take(reader, &sample, &info, 1, 1);
    if (count <= 0) return;
    const bool more = function(*static_cast<const Message*>(sample), info);
    dds_return_loan(reader, &sample, 1);
    if (!more) return;
  }
}

/// A publisher of another participant, from discovery.
struct Publication {
  std::string key, participant;  ///< global identifiers of DDS, 16 bytes
  std::string topic, type;
  bool reliable = true;
  bool fast_dds = false;  ///< by the vendor in the first bytes of its address
  bool has_hash = false;  ///< of its type, as since Iron
};

template <std::size_t N>
std::string text_of(const std::uint8_t (&bytes)[N]) {
  return {reinterpret_cast<const char*>(bytes), N};
}

class Publications {
 public:
  explicit Publications(dds_entity_t participant)
      : reader_("discovery", dds_create_reader(participant, DDS_BUILTIN_TOPIC_DCPSPUBLICATION,
                                               nullptr, nullptr)) {}

  dds_entity_t reader() const { return reader_; }

  void update() {
    take_all<dds_builtintopic_endpoint_t>(
        reader_,
        [this](const dds_builtintopic_endpoint_t& endpoint, const dds_sample_info_t& info) {
          const std::string key = text_of(endpoint.key.v);
          if (info.instance_state == DDS_IST_ALIVE && info.valid_data)
            all_[key] = publication_of(endpoint);
          else
            all_.erase(key);
          return true;
        });
  }

  std::vector<Publication> on(const std::string& topic) const {
    std::vector<Publication> found;
    for (const auto& [key, one] : all_)
      if (one.topic == topic) found.push_back(one);
    return found;
  }

 private:
  static Publication publication_of(const dds_builtintopic_endpoint_t& endpoint) {
    dds_reliability_kind_t kind = DDS_RELIABILITY_BEST_EFFORT;
    dds_duration_t blocking = 0;
    dds_qget_reliability(endpoint.qos, &kind, &blocking);
    void* data = nullptr;
    std::size_t size = 0;
    dds_qget_userdata(endpoint.qos, &data, &size);
    const std::string user_data(static_cast<const char*>(data), size);
    dds_free(data);
    const std::uint8_t* vendor = endpoint.participant_key.v;
    return {text_of(endpoint.key.v),
            text_of(endpoint.participant_key.v),
            endpoint.topic_name,
            endpoint.type_name,
            kind == DDS_RELIABILITY_RELIABLE,
            vendor[0] == 0x01 && vendor[1] == 0x0f,
            user_data.find("typehash=") != std::string::npos};
  }

  Entity reader_;
  std::map<std::string, Publication> all_;
};

Entity make_reader(dds_entity_t participant, const std::string& topic,
                   const dds_topic_descriptor_t* type, const Qos& qos) {
  const Entity handle(topic, dds_create_topic(participant, type, topic.c_str(), nullptr, nullptr));
  Entity reader(topic, dds_create_reader(participant, handle, qos.get(), nullptr));
  dds_set_status_mask(reader, DDS_DATA_AVAILABLE_STATUS);
  return reader;
}

Entity make_writer(dds_entity_t participant, const std::string& topic,
                   const dds_topic_descriptor_t* type, const Qos& qos) {
  const Entity handle(topic, dds_create_topic(participant, type, topic.c_str(), nullptr, nullptr));
  return {topic, dds_create_writer(participant, handle, qos.get(), nullptr)};
}

/// The names of the nodes of other participants, which these announce with their publishers (REP
/// 2005's graph). Before Iron an identifier has 24 bytes there, since then 16.
class NodeNames {
 public:
  explicit NodeNames(dds_entity_t participant) : participant_(participant) {}

  void update(const Publications& publications) {
    for (const Publication& one : publications.on(kTopic))
      if (one.has_hash)
        take<slalom_ros2_Participant>(reader_, slalom_ros2_Participant_desc);
      else
        take<slalom_ros2_ParticipantOfHumble>(old_reader_, slalom_ros2_ParticipantOfHumble_desc);
  }

  /// The node of a publisher, e.g. "/controller_server"; "" if it is not announced.
  std::string node_of(const Publication& publisher) const {
    const auto found = names_.find(publisher.key);
    return found == names_.end() ? "" : found->second;
  }

 private:
  static constexpr char kTopic[] = "ros_discovery_info";

  template <typename Message>
  void take(Entity& reader, dds_topic_descriptor_t type) {
    if (reader <= 0) {
      type.m_typename = "rmw_dds_common::msg::dds_::ParticipantEntitiesInfo_";
      const Qos qos = make_qos(true, true, nullptr);
      dds_qset_history(qos.get(), DDS_HISTORY_KEEP_ALL, 0);
      reader = make_reader(participant_, kTopic, &type, qos);
    }
    take_all<Message>(reader, [this](const Message& message, const dds_sample_info_t& info) {
      if (info.valid_data) keep(message);
      return true;
    });
  }

  template <typename Message>
  void keep(const Message& message) {
    if (names_.size() > kMaxNames) names_.clear();
    for (std::uint32_t i = 0; i < message.nodes._length; ++i) {
      const auto& node = message.nodes._buffer[i];
      const std::string space = node.name_space;
      const std::string name = (space == "/" ? "" : space) + "/" + node.name;
      for (std::uint32_t j = 0; j < node.writers._length; ++j)
        names_[text_of(node.writers._buffer[j].data).substr(0, kIdentifier)] = name;
    }
  }

  static constexpr std::size_t kIdentifier = 16;  // bytes
  static constexpr std::size_t kMaxNames = 10'000;
  dds_entity_t participant_;
  Entity reader_, old_reader_;
  std::map<std::string, std::string> names_;  ///< by publisher
};

/// A service of the parameters of a node. The bodies of its messages have the same encoding in both
/// middlewares.
struct Service {
  std::string name, type;
  const dds_topic_descriptor_t *cyclone_request, *cyclone_reply, *fast_request, *fast_reply;
};
const Service kGetTypes = {"get_parameter_types",          "GetParameterTypes",
                           &slalom_ros2_CycloneNames_desc, &slalom_ros2_CycloneTypes_desc,
                           &slalom_ros2_NameList_desc,     &slalom_ros2_TypeList_desc};
const Service kGetValues = {"get_parameters",
                            "GetParameters",
                            &slalom_ros2_CycloneNames_desc,
                            &slalom_ros2_CycloneValues_desc,
                            &slalom_ros2_NameList_desc,
                            &slalom_ros2_ValueList_desc};
const Service kSetValues = {"set_parameters",
                            "SetParameters",
                            &slalom_ros2_CycloneParameters_desc,
                            &slalom_ros2_CycloneResults_desc,
                            &slalom_ros2_ParameterList_desc,
                            &slalom_ros2_ResultList_desc};

/// A client of a service of a node, with one question at a time.
///
/// A node that has not found the reader of its replies yet loses them. The first question is
/// therefore asked again until there is a reply, with one more copy of its content each time:
/// replies on Fast DDS have no number here, but as many values as their question has copies.
class Client {
 public:
  Client(dds_entity_t participant, const std::string& node, const Service& service)
      : participant_(participant), topic_(node + "/" + service.name), service_(service) {}

  /// Whether the node offers its service and has found this client.
  bool is_matched(const Publications& publications) {
    const auto replies = publications.on("rr" + topic_ + "Reply");
    if (replies.empty()) return false;
    if (request_ <= 0) connect(replies.front().fast_dds);
    dds_publication_matched_status_t readers;
    dds_subscription_matched_status_t writers;
    dds_get_publication_matched_status(request_, &readers);
    dds_get_subscription_matched_status(reply_, &writers);
    const bool is_matched = readers.current_count > 0 && writers.current_count > 0;
    if (!is_matched) is_heard_ = false;
    return is_matched;
  }

  /// Whether no question is open, or the first one is to be asked again.
  bool must_ask() const {
    return !is_open_ || (!is_heard_ && Steady::now() - asked_at_ >= kPatience);
  }
  /// The number of copies of the content of the next question.
  std::size_t copies() const { return is_open_ ? copies_ + 1 : copies_; }

  /// Asks by a message of Cyclone, with its body.
  template <typename Message>
  void ask(Message message) {
    copies_ = copies();
    message.client = kClient;
    message.number = ++number_;
    check("question",
          dds_write(request_, fast_dds_ ? static_cast<void*>(&message.body) : &message));
    is_open_ = true;
    asked_at_ = Steady::now();
  }

  /// Passes the body of the reply on, after waiting up to this time (s); false if there is none.
  /// Replies to other clients and questions have other numbers, or another number of values: none
  /// if the node knows no such parameter.
  template <typename Message, typename Function>
  bool await_reply(double seconds, Function function) {
    if (take_reply<Message>(function)) return true;
    dds_attach_t hit = 0;
    dds_waitset_wait(waitset_, &hit, 1, static_cast<dds_duration_t>(seconds * 1e9));
    return take_reply<Message>(function);
  }

 private:
  using Steady = std::chrono::steady_clock;
  static constexpr std::uint64_t kClient = 0x51a10a;
  static constexpr std::chrono::seconds kPatience{1};

  /// The types have the names of ROS 2, not those of this program.
  void connect(bool fast_dds) {
    fast_dds_ = fast_dds;
    request_type_.emplace(fast_dds ? *service_.fast_request : *service_.cyclone_request);
    reply_type_.emplace(fast_dds ? *service_.fast_reply : *service_.cyclone_reply);
    request_name_ = "rcl_interfaces::srv::dds_::" + service_.type + "_Request_";
    reply_name_ = "rcl_interfaces::srv::dds_::" + service_.type + "_Response_";
    request_type_->m_typename = request_name_.c_str();
    reply_type_->m_typename = reply_name_.c_str();
    const Qos qos = make_qos(true, false, nullptr);
    reply_ = make_reader(participant_, "rr" + topic_ + "Reply", &*reply_type_, qos);
    request_ = make_writer(participant_, "rq" + topic_ + "Request", &*request_type_, qos);
    waitset_ = Entity("waitset", dds_create_waitset(participant_));
    dds_waitset_attach(waitset_, reply_, 0);
  }

  template <typename Message, typename Function>
  bool take_reply(const Function& function) {
    using Body = decltype(Message::body);
    bool found = false;
    take_all<Message>(reply_, [&](const Message& reply, const dds_sample_info_t& info) {
      if (!info.valid_data) return true;
      const Body& body = fast_dds_ ? reinterpret_cast<const Body&>(reply) : reply.body;
      const std::size_t values = size_of(body);
      found = fast_dds_ ? values == 0 || values == copies_
                        : reply.client == kClient && reply.number == number_;
      if (found) function(body);
      return !found;
    });
    if (found) {
      is_open_ = false;
      is_heard_ = true;
    }
    return found;
  }

  static std::size_t size_of(const slalom_ros2_TypeList& reply) { return reply.types._length; }
  static std::size_t size_of(const slalom_ros2_ValueList& reply) { return reply.values._length; }
  static std::size_t size_of(const slalom_ros2_ResultList& reply) { return reply.results._length; }

  dds_entity_t participant_;
  std::string topic_;
  Service service_;
  bool fast_dds_ = false;
  bool is_open_ = false;   ///< a question without reply
  bool is_heard_ = false;  ///< there has been a reply since the node was found
  Steady::time_point asked_at_;
  std::size_t copies_ = 1;
  std::int64_t number_ = 0;
  std::optional<dds_topic_descriptor_t> request_type_, reply_type_;
  std::string request_name_, reply_name_;
  Entity request_, reply_, waitset_;
};

/// A question with copies of a name.
class NameQuestion {
 public:
  NameQuestion(std::string name, std::size_t copies)
      : name_(std::move(name)), names_(copies, name_.data()) {}

  slalom_ros2_CycloneNames message() {
    slalom_ros2_CycloneNames message{};
    message.body.names._buffer = names_.data();
    message.body.names._length = message.body.names._maximum =
        static_cast<std::uint32_t>(names_.size());
    return message;
  }

 private:
  std::string name_;
  std::vector<char*> names_;
};

/// A question to a node, which it answers after the callbacks of the data that it received before:
/// services and subscriptions are in one callback group by default.
class Barrier {
 public:
  Barrier(dds_entity_t participant, const std::string& node)
      : client_(participant, node, kGetTypes) {}

  bool is_matched(const Publications& publications) { return client_.is_matched(publications); }

  bool pass(double seconds) {
    if (client_.must_ask()) client_.ask(NameQuestion("use_sim_time", client_.copies()).message());
    return client_.await_reply<slalom_ros2_CycloneTypes>(seconds, [](const auto&) {});
  }

 private:
  Client client_;
};

/// The values of parameters by their type (rcl_interfaces/msg/ParameterType).
constexpr std::uint8_t kNotSet = 0, kBool = 1, kInteger = 2, kDouble = 3, kString = 4;
constexpr std::array kTypeNames = {"nothing", "a bool", "an integer", "a double", "a string"};

std::string describe(const NodeParameter& parameter) {
  return "parameter " + parameter.name + " of the node " + parameter.node;
}

bool has_value(const slalom_ros2_ParameterValue& value, const std::string& text) {
  long long integer = 0;
  double number = 0;
  if (value.type == kBool) return text == (value.bool_value ? "true" : "false");
  if (value.type == kInteger) return parse_integer(text, integer) && integer == value.integer_value;
  if (value.type == kDouble) return parse_number(text, number) && number == value.double_value;
  return value.type == kString && text == value.string_value;
}

/// The value of a parameter of this type, which refers to its text.
slalom_ros2_ParameterValue value_of(const NodeParameter& parameter, std::uint8_t type) {
  if (type > kString)
    throw NodeParameterError("the " + describe(parameter) +
                             " is an array; expected a bool, an integer, a double or a string");
  slalom_ros2_ParameterValue value{};
  value.type = type;
  value.bool_value = parameter.value == "true";
  long long integer = 0;
  parse_integer(parameter.value, integer);
  value.integer_value = integer;
  parse_number(parameter.value, value.double_value);
  value.string_value = const_cast<char*>(parameter.value.c_str());  // written, never changed
  if (!has_value(value, parameter.value))
    throw NodeParameterError("the " + describe(parameter) + " is " + kTypeNames.at(type) +
                             ", not '" + parameter.value + "'");
  return value;
}

/// Sets parameters of a node, one after another.
class NodeParameters {
 public:
  NodeParameters(dds_entity_t participant, const std::string& node)
      : get_(participant, node, kGetValues), set_(participant, node, kSetValues) {}

  bool is_matched(const Publications& publications) {
    const bool can_get = get_.is_matched(publications), can_set = set_.is_matched(publications);
    return can_get && can_set;
  }

  /// See RosLink::set_parameter(). Asks one question at most.
  std::string apply(const NodeParameter& parameter, double seconds) {
    return type_ == kNotSet ? read(parameter, seconds) : set(parameter, seconds);
  }

 private:
  std::string read(const NodeParameter& parameter, double seconds) {
    std::uint8_t type = kNotSet;
    bool is_equal = false;
    if (get_.must_ask()) get_.ask(NameQuestion(parameter.name, get_.copies()).message());
    const auto receive = [&](const slalom_ros2_ValueList& reply) {
      if (reply.values._length == 0) return;
      type = reply.values._buffer[0].type;
      is_equal = has_value(reply.values._buffer[0], parameter.value);
    };
    if (!get_.await_reply<slalom_ros2_CycloneValues>(seconds, receive))
      return (is_absent_ ? "" : "reply about the ") + describe(parameter);
    is_absent_ = type == kNotSet;
    if (is_absent_) return describe(parameter);
    const bool was_set = std::exchange(was_set_, false);
    if (is_equal) return "";
    if (was_set)
      throw NodeParameterError("the " + describe(parameter) + " does not keep its value");
    value_of(parameter, type);
    type_ = type;
    return "reply about the " + describe(parameter);
  }

  std::string set(const NodeParameter& parameter, double seconds) {
    if (set_.must_ask()) {
      std::vector<slalom_ros2_Parameter> copies(
          set_.copies(), {const_cast<char*>(parameter.name.c_str()), value_of(parameter, type_)});
      slalom_ros2_CycloneParameters message{};
      message.body.parameters._buffer = copies.data();
      message.body.parameters._length = message.body.parameters._maximum =
          static_cast<std::uint32_t>(copies.size());
      set_.ask(message);
    }
    std::string reason = "no result";
    bool is_done = false;
    const auto receive = [&](const slalom_ros2_ResultList& reply) {
      if (reply.results._length == 0) return;
      is_done = reply.results._buffer[0].successful;
      reason = reply.results._buffer[0].reason;
    };
    if (set_.await_reply<slalom_ros2_CycloneResults>(seconds, receive)) {
      type_ = kNotSet;
      was_set_ = is_done;
      if (!is_done)
        throw NodeParameterError("the node " + parameter.node + " refuses " + parameter.name +
                                 " = " + parameter.value + ": " + reason);
    }
    return "reply about the " + describe(parameter);
  }

  Client get_, set_;
  std::uint8_t type_ = kNotSet;  ///< of the parameter that is to be set
  bool was_set_ = false;         ///< and is to be read again
  bool is_absent_ = false;       ///< the node has said so; it may declare it later
};

builtin_interfaces_msg_dds__Time_ to_ros(RosTime time) {
  return {static_cast<std::int32_t>(time / 1'000'000'000),
          static_cast<std::uint32_t>(time % 1'000'000'000)};
}

geometry_msgs_msg_dds__Quaternion_ to_ros(double heading) {
  return {0, 0, math::sin(heading / 2), math::cos(heading / 2)};
}

/// Yaw after a roll of pi if it is upside down.
geometry_msgs_msg_dds__Transform_ mount_of(const LaserModel& laser) {
  geometry_msgs_msg_dds__Transform_ mount{};
  mount.translation = {laser.x, laser.y, 0};
  mount.rotation = to_ros(laser.yaw);
  if (laser.upside_down) mount.rotation = {mount.rotation.w, mount.rotation.z, 0, 0};
  return mount;
}

class CycloneLink : public RosLink {
 public:
  CycloneLink(const Ros2Options& options, int domain, const SensorModel& sensor)
      : options_(options),
        nodes_(barrier_nodes(options)),
        parameters_(node_parameters(options)),
        command_topic_(topic(options.command)),
        lasers_(sensor.all_lasers()),
        domain_("domain",
                dds_create_domain(static_cast<dds_domainid_t>(domain), local_host(domain).c_str())),
        participant_("participant",
                     dds_create_participant(static_cast<dds_domainid_t>(domain), nullptr, nullptr)),
        waitset_("waitset", dds_create_waitset(participant_)),
        publications_(participant_),
        node_names_(participant_),
        clock_(writer("/clock", kClock)),
        odometry_(writer(options.odometry, kOdometry)),
        transforms_(writer(options.tf, kTransforms)),
        static_transforms_(writer(options.tf + "_static", kTransforms, true)),
        goal_(writer(options.goal, kPose, true)) {
    for (const LaserModel& laser : lasers_) scans_.push_back(writer(scan_topic(laser), kScan));
    if (options.map == Ros2Map::Known) map_ = writer(options.map_topic, kGrid, true);
    for (const std::string& node : nodes_) barriers_.try_emplace(node, participant_, node);
    for (const NodeParameter& one : parameters_)
      node_parameters_.try_emplace(one.node, participant_, one.node);
    dds_waitset_attach(waitset_, publications_.reader(), 0);
    dds_set_status_mask(publications_.reader(), DDS_DATA_AVAILABLE_STATUS);
    send_static_transforms();
  }

  std::vector<std::string> missing() override {
    publications_.update();
    node_names_.update(publications_);
    follow_command_type();
    std::vector<std::string> missing;
    for (std::size_t i = 0; i < lasers_.size(); ++i) {
      dds_publication_matched_status_t readers;
      dds_get_publication_matched_status(scans_[i], &readers);
      if (readers.current_count == 0)
        missing.push_back("reader of " + name(scan_topic(lasers_[i])) +
                          incompatible_policy(scans_[i]));
    }
    dds_subscription_matched_status_t writers = {};
    if (command_ > 0) dds_get_subscription_matched_status(command_, &writers);
    if (writers.current_count == 0) missing.push_back("publisher of " + name(options_.command));
    std::set<std::string> nodes;
    for (auto& [node, barrier] : barriers_)
      if (!barrier.is_matched(publications_)) nodes.insert(node);
    for (auto& [node, parameters] : node_parameters_)
      if (!parameters.is_matched(publications_)) nodes.insert(node);
    for (const std::string& node : nodes) missing.push_back("node " + node + " with parameters");
    return missing;
  }

  std::string set_parameter(std::size_t parameter, double seconds) override {
    const NodeParameter& one = parameters_[parameter];
    return node_parameters_.at(one.node).apply(one, seconds);
  }

  /// Nodes of one participant that are not announced are counted as one.
  std::vector<std::string> publishers() override {
    publications_.update();
    node_names_.update(publications_);
    std::map<std::string, std::set<std::string>> names;  // by participant
    for (const Publication& one : publications_.on(command_topic_)) {
      std::set<std::string>& of_participant = names[one.participant];
      if (const std::string name = node_names_.node_of(one); !name.empty())
        of_participant.insert(name);
    }
    std::vector<std::string> nodes;
    for (const auto& [participant, of_participant] : names) {
      if (of_participant.empty()) nodes.emplace_back("a node without a name");
      nodes.insert(nodes.end(), of_participant.begin(), of_participant.end());
    }
    std::sort(nodes.begin(), nodes.end());
    return nodes;
  }

  void send_goal(const mrpt::math::TPose2D& goal, RosTime stamp) override {
    geometry_msgs_msg_dds__PoseStamped_ message{};
    message.header = header(options_.map_frame, stamp);
    message.pose.position = {goal.x, goal.y, 0};
    message.pose.orientation = to_ros(goal.phi);
    write(goal_, message);
  }

  void send_map(const KnownMap& map, RosTime stamp) override {
    std::vector<std::uint8_t> cells(map.cells->size());
    std::transform(map.cells->begin(), map.cells->end(), cells.begin(),
                   [](std::uint8_t cell) { return cell == 0 ? 0 : 100; });
    nav_msgs_msg_dds__OccupancyGrid_ message{};
    message.header = header(options_.map_frame, stamp);
    message.info.map_load_time = to_ros(stamp);
    message.info.resolution = static_cast<float>(map.resolution);
    message.info.width = static_cast<std::uint32_t>(map.size_x);
    message.info.height = static_cast<std::uint32_t>(map.size_y);
    message.info.origin.position = {map.origin.x, map.origin.y, 0};
    message.info.origin.orientation = to_ros(0.0);
    message.data._buffer = cells.data();
    message.data._length = message.data._maximum = static_cast<std::uint32_t>(cells.size());
    write(map_, message);
  }

  void await_map() override {
    dds_wait_for_acks(map_, static_cast<dds_duration_t>(kMapTime * 1e9));
  }

  void send_transform(const Observation& observation, RosTime now) override {
    geometry_msgs_msg_dds__TransformStamped_ one{};
    one.header = header(options_.odometry_frame, now);
    one.child_frame_id = const_cast<char*>(options_.base_frame.c_str());
    one.transform.translation = {observation.odometry.x, observation.odometry.y, 0};
    one.transform.rotation = to_ros(observation.odometry.phi);
    tf2_msgs_msg_dds__TFMessage_ message{};
    message.transforms._buffer = &one;
    message.transforms._length = message.transforms._maximum = 1;
    write(transforms_, message);
  }

  void send_odometry(const Observation& observation, RosTime now) override {
    nav_msgs_msg_dds__Odometry_ message{};
    message.header = header(options_.odometry_frame, now);
    message.child_frame_id = const_cast<char*>(options_.base_frame.c_str());
    message.pose.pose.position = {observation.odometry.x, observation.odometry.y, 0};
    message.pose.pose.orientation = to_ros(observation.odometry.phi);
    message.twist.twist.linear = {observation.v, observation.vy, 0};
    message.twist.twist.angular = {0, 0, observation.w};
    write(odometry_, message);
  }

  void send_scans(const Observation& observation, RosTime scan_time) override {
    if (observation.lasers.empty() && !lasers_.front().name.empty())
      throw MethodError("there are no scans of the robot's lasers, as in the replay of a log");
    if (observation.lasers.empty()) return send_scan(0, *observation.scan, scan_time);
    for (std::size_t i = 0; i < observation.lasers.size(); ++i)
      send_scan(i, *observation.lasers[i], scan_time);
  }

  void send_clock(RosTime now) override {
    rosgraph_msgs_msg_dds__Clock_ message{};
    message.clock = to_ros(now);
    write(clock_, message);
  }

  bool pass_barrier(std::size_t node, double seconds) override {
    return barriers_.at(nodes_[node]).pass(seconds);
  }

  std::optional<RosCommand> take_command() override {
    std::optional<RosCommand> command;
    if (command_ <= 0) return command;
    if (is_stamped_)
      take_all<geometry_msgs_msg_dds__TwistStamped_>(
          command_, [&](const auto& message, const dds_sample_info_t& info) {
            if (!info.valid_data) return true;
            const auto& stamp = message.header.stamp;
            command = {velocity_of(message.twist),
                       stamp.sec * RosTime{1'000'000'000} + static_cast<RosTime>(stamp.nanosec)};
            return false;
          });
    else
      take_all<geometry_msgs_msg_dds__Twist_>(
          command_, [&](const auto& message, const dds_sample_info_t& info) {
            if (!info.valid_data) return true;
            command = {velocity_of(message), std::nullopt};
            return false;
          });
    return command;
  }

  void wait(double seconds) override {
    dds_attach_t hit = 0;
    dds_waitset_wait(waitset_, &hit, 1, static_cast<dds_duration_t>(seconds * 1e9));
  }

 private:
  std::string name(const std::string& key) const { return ros_name(options_, key); }
  std::string topic(const std::string& key) const { return "rt" + name(key); }
  /// The name of a topic or frame of a laser, which ends with that of one of several.
  std::string of_laser(const std::string& key, const LaserModel& laser) const {
    return lasers_.size() > 1 ? key + "_" + laser.name : key;
  }
  std::string scan_topic(const LaserModel& laser) const { return of_laser(options_.scan, laser); }
  std::string frame_of(const LaserModel& laser) const {
    return of_laser(options_.scan_frame, laser);
  }

  Entity writer(const std::string& key, const Type& type, bool latched = false) const {
    return make_writer(participant_, topic(key), type.descriptor,
                       make_qos(true, latched, type.hash));
  }

  template <typename Message>
  static void write(dds_entity_t writer, const Message& message) {
    check("write", dds_write(writer, &message));
  }

  static Command velocity_of(const geometry_msgs_msg_dds__Twist_& twist) {
    return {twist.linear.x, twist.angular.z, twist.linear.y};
  }

  static std_msgs_msg_dds__Header_ header(const std::string& frame, RosTime stamp) {
    return {to_ros(stamp), const_cast<char*>(frame.c_str())};  // written, never changed
  }

  /// Reads commands in the type in which they are published. A best-effort publisher does not match
  /// a reliable reader.
  void follow_command_type() {
    const auto found = publications_.on(command_topic_);
    if (found.empty()) return;
    const bool is_stamped = found.front().type == kTwistStamped.descriptor->m_typename;
    for (const Publication& one : found)
      if (one.type != kTwist.descriptor->m_typename &&
          one.type != kTwistStamped.descriptor->m_typename)
        throw MethodError(name(options_.command) + " has the type " + one.type +
                          "; expected Twist or TwistStamped of geometry_msgs");
    const bool is_reliable = std::all_of(found.begin(), found.end(),
                                         [](const Publication& one) { return one.reliable; });
    if (command_ > 0 && is_stamped == is_stamped_ && is_reliable == is_reliable_) return;
    const Type& type = is_stamped ? kTwistStamped : kTwist;
    command_ = {};
    command_ = make_reader(participant_, command_topic_, type.descriptor,
                           make_qos(is_reliable, false, type.hash));
    dds_waitset_attach(waitset_, command_, 0);
    is_stamped_ = is_stamped;
    is_reliable_ = is_reliable;
  }

  /// The policy by which a reader of scans asks for more than is offered; "" if there is none.
  static std::string incompatible_policy(dds_entity_t scans) {
    dds_offered_incompatible_qos_status_t status;
    dds_get_offered_incompatible_qos_status(scans, &status);
    if (status.total_count == 0) return "";
    const bool durable = status.last_policy_id == DDS_DURABILITY_QOS_POLICY_ID;
    return " with a compatible QoS (" +
           (durable ? std::string("durability: scans are volatile")
                    : "policy " + std::to_string(status.last_policy_id)) +
           ")";
  }

  void send_static_transforms() {
    std::vector<std::string> frames;  // children, in the order of the transforms
    std::vector<geometry_msgs_msg_dds__TransformStamped_> transforms;
    const auto add = [&](const std::string& parent, const std::string& child,
                         const LaserModel& mount) {
      if (parent == child) return;  // the same frame has no transform
      transforms.emplace_back();
      transforms.back().header = header(parent, 0);
      transforms.back().transform = mount_of(mount);
      frames.push_back(child);
    };
    add(options_.map_frame, options_.odometry_frame, {});
    for (const LaserModel& laser : lasers_) add(options_.base_frame, frame_of(laser), laser);
    for (std::size_t i = 0; i < frames.size(); ++i) transforms[i].child_frame_id = frames[i].data();
    tf2_msgs_msg_dds__TFMessage_ message{};
    message.transforms._buffer = transforms.data();
    message.transforms._length = message.transforms._maximum =
        static_cast<std::uint32_t>(transforms.size());
    write(static_transforms_, message);
  }

  /// Rays without return are +inf, as REP 117 requires.
  void send_scan(std::size_t index, const mrpt::obs::CObservation2DRangeScan& scan, RosTime time) {
    const LaserModel& laser = lasers_[index];
    const std::size_t rays = scan.getScanSize();
    ranges_.resize(rays);
    for (std::size_t i = 0; i < rays; ++i)
      ranges_[i] = scan.getScanRangeValidity(i) ? scan.getScanRange(i)
                                                : std::numeric_limits<float>::infinity();
    const double aperture = laser.aperture();
    const std::string frame = frame_of(laser);
    sensor_msgs_msg_dds__LaserScan_ message{};
    message.header = header(frame, time);
    message.angle_min = static_cast<float>(-aperture / 2);
    message.angle_max = static_cast<float>(aperture / 2);
    message.angle_increment = static_cast<float>(aperture / static_cast<double>(rays - 1));
    message.range_min = static_cast<float>(laser.range_min);
    message.range_max = static_cast<float>(laser.max_range);
    message.ranges._buffer = ranges_.data();
    message.ranges._length = message.ranges._maximum = static_cast<std::uint32_t>(rays);
    write(scans_[index], message);
  }

  Ros2Options options_;
  std::vector<std::string> nodes_;  ///< of the barrier, in its order
  std::vector<NodeParameter> parameters_;
  std::string command_topic_;
  std::vector<LaserModel> lasers_;
  Entity domain_, participant_, waitset_;
  Publications publications_;
  NodeNames node_names_;
  Entity clock_, odometry_, transforms_, static_transforms_, goal_, map_;
  std::vector<Entity> scans_;  ///< of lasers_
  Entity command_;
  bool is_stamped_ = false, is_reliable_ = true;
  std::map<std::string, Barrier> barriers_;  ///< by node: each reply is to one question
  std::map<std::string, NodeParameters> node_parameters_;
  std::vector<float> ranges_;
};

}  // namespace
}  // namespace slalom

extern "C" __attribute__((visibility("default"))) slalom::RosLink* slalom_ros2_make_link(
    const slalom::Ros2Options& options, int domain, const slalom::SensorModel& sensor) {
  return new slalom::CycloneLink(options, domain, sensor);
}
