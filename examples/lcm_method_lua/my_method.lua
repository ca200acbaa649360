-- An avoidance method as a process of its own, in Lua (Debian: lua5.2, liblcm-lua, liblcm-bin): turns to
-- the free direction that is nearest to the goal. The messages lie in types/ (see campaign.ini).
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

local function refuse(id, why)
  local answer = slalom.error_t:new()
  answer.id, answer.text = id, why
  lc:publish(channel .. '_ERROR', answer:encode())
end

local function greet(_, data)
  local hello = slalom.hello_t.decode(data)
  if hello.protocol_version ~= PROTOCOL_VERSION then
    return refuse(hello.id, 'my_method.lua is made for another version of the protocol')
  end
  for i, key in ipairs(hello.keys) do
    if key ~= 'look_ahead' then return refuse(hello.id, 'I only know look_ahead') end
    look_ahead = tonumber(hello.values[i])
  end
  robot = hello
  ready(hello.id)
end

-- A method that remembers something forgets it here.
local function start(_, data)
  ready(slalom.run_start_t.decode(data).run_id)
end

local function clamp(value, low, high) return math.max(low, math.min(high, value)) end

local function angle_of(i) return robot.aperture * ((i - 1) / (robot.rays - 1) - 0.5) end

-- How far the robot can go straight in a direction, m.
local function free_way(ranges, direction)
  local free = robot.max_range
  for i, range in ipairs(ranges) do
    local angle = angle_of(i) - direction
    if math.cos(angle) > 0 and math.abs(range * math.sin(angle)) < robot.radius + 0.1 then
      free = math.min(free, range * math.cos(angle) - robot.radius)
    end
  end
  return free
end

local function decide(_, data)
  local o = slalom.observation_t.decode(data)
  local goal = math.atan2(o.goal_y, o.goal_x)
  local wanted = math.min(look_ahead, math.sqrt(o.goal_x ^ 2 + o.goal_y ^ 2))
  local command = slalom.command_t:new()
  command.run_id, command.sequence = o.run_id, o.sequence
  command.v, command.w, command.vy = 0, robot.max_w / 2, 0 -- nothing is free: look round
  local best = math.huge
  for i = 1, o.rays, 4 do
    local direction = angle_of(i)
    if math.abs(direction - goal) < best and free_way(o.ranges, direction) >= wanted then
      best = math.abs(direction - goal)
      command.w = clamp(2 * direction, -robot.max_w, robot.max_w)
      command.v = clamp(free_way(o.ranges, 0) - 0.1, 0, robot.max_v) * math.max(0, math.cos(direction))
    end
  end
  lc:publish(channel .. '_COMMAND', command:encode())
end

lc:subscribe(channel .. '_HELLO', greet)
lc:subscribe(channel .. '_RUN_START', start)
lc:subscribe(channel .. '_OBSERVATION', decide)
while true do lc:handle() end
