-- An avoidance method as a separate process, in Lua (Debian: lua5.2, liblcm-lua, liblcm-bin): turns to the
-- free direction closest to the goal. The generated messages are in types/ (see campaign.ini).
package.path = 'types/?.lua;types/?/init.lua;' .. package.path
local lcm = require('lcm')
local slalom = require('slalom')

local PROTOCOL_VERSION = 1
local url = os.getenv('SLALOM_LCM_URL') or 'udpm://239.255.76.67:7667?ttl=0'
local channel = os.getenv('SLALOM_LCM_CHANNEL') or 'SLALOM'
local lc = lcm.lcm.new(url)
local robot, look_ahead = nil, 1.0

local function ready(id)
  local answer = slalom.ready_t:new()
  answer.protocol_version, answer.id, answer.name = PROTOCOL_VERSION, id, 'my_method.lua'
  lc:publish(channel .. '_READY', answer:encode())
end

local function refuse(id, reason)
  local answer = slalom.error_t:new()
  answer.id, answer.text = id, reason
  lc:publish(channel .. '_ERROR', answer:encode())
end

local function handle_hello(_, data)
  local hello = slalom.hello_t.decode(data)
  if hello.protocol_version ~= PROTOCOL_VERSION then
    return refuse(hello.id, 'my_method.lua requires another protocol version')
  end
  for i, key in ipairs(hello.keys) do
    if key ~= 'look_ahead' then return refuse(hello.id, 'unknown setting; expected look_ahead') end
    look_ahead = tonumber(hello.values[i])
  end
  robot = hello
  ready(hello.id)
end

-- A method with state must clear it here.
local function handle_run_start(_, data)
  ready(slalom.run_start_t.decode(data).run_id)
end

local function clamp(value, low, high) return math.max(low, math.min(high, value)) end

local function angle_of(i) return robot.aperture * ((i - 1) / (robot.rays - 1) - 0.5) end

-- Free distance of the robot straight in a direction, m.
local function free_distance(ranges, direction)
  local free = robot.max_range
  for i, range in ipairs(ranges) do
    local angle = angle_of(i) - direction
    if math.cos(angle) > 0 and math.abs(range * math.sin(angle)) < robot.radius + 0.1 then
      free = math.min(free, range * math.cos(angle) - robot.radius)
    end
  end
  return free
end

local function handle_observation(_, data)
  local o = slalom.observation_t.decode(data)
  local goal = math.atan2(o.goal_y, o.goal_x)
  local desired_distance = math.min(look_ahead, math.sqrt(o.goal_x ^ 2 + o.goal_y ^ 2))
  local command = slalom.command_t:new()
  command.run_id, command.sequence = o.run_id, o.sequence
  command.v, command.w, command.vy = 0, robot.max_w / 2, 0 -- no free direction: rotate
  local best = math.huge
  for i = 1, o.rays, 4 do
    local direction = angle_of(i)
    if math.abs(direction - goal) < best and free_distance(o.ranges, direction) >= desired_distance then
      best = math.abs(direction - goal)
      command.w = clamp(2 * direction, -robot.max_w, robot.max_w)
      command.v = clamp(free_distance(o.ranges, 0) - 0.1, 0, robot.max_v) * math.max(0, math.cos(direction))
    end
  end
  lc:publish(channel .. '_COMMAND', command:encode())
end

lc:subscribe(channel .. '_HELLO', handle_hello)
lc:subscribe(channel .. '_RUN_START', handle_run_start)
lc:subscribe(channel .. '_OBSERVATION', handle_observation)
while true do lc:handle() end
