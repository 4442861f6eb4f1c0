-- Liveness of relays and ownership of pages. All times are those of Redis.
-- KEYS: 1 the robot's session, 2 its channel, 3 relays by the time until which they count as alive.
local step, given, relay = ARGV[1], cjson.decode(ARGV[2]), ARGV[3]
local SESSION, CHANNEL, RELAYS = unpack(KEYS)
local clock = redis.call('TIME')
local now = clock[1] * 1000 + math.floor(clock[2] / 1000)

local steps = {}

-- The stored page of the robot, if its relay is alive.
local function holderOf(session)
  local page = redis.call('HGET', session, 'page')
  if not page then return nil end
  local alive = tonumber(redis.call('ZSCORE', RELAYS, cjson.decode(page).relay) or 0)
  return alive >= now and page or nil
end

-- Heartbeat of this relay. Returns whether it had counted as dead, and the pages of these robots.
function steps.beat()
  local before = tonumber(redis.call('ZSCORE', RELAYS, relay) or 0)
  redis.call('ZADD', RELAYS, now + given.ms, relay)
  redis.call('ZREMRANGEBYSCORE', RELAYS, '-inf', '(' .. now)
  local holders = {}
  for i, session in ipairs(given.sessions) do holders[i] = holderOf(session) or 'null' end
  return '{"lapsed":' .. tostring(before < now) .. ',"holders":[' .. table.concat(holders, ',') .. ']}'
end

function steps.stop()
  redis.call('ZREM', RELAYS, relay)
  return 'null'
end

function steps.holder()
  return holderOf(SESSION) or 'null'
end

-- Removes the page with this epoch, because it disconnected, and publishes that.
function steps.left()
  local page = redis.call('HGET', SESSION, 'page')
  if page and cjson.decode(page).epoch == given.epoch then
    redis.call('HDEL', SESSION, 'page')
    redis.call('PUBLISH', CHANNEL,
      '{"kind":"page-left","from":"' .. relay .. '","epoch":' .. given.epoch ..
      ',"closedByPage":' .. tostring(given.closedByPage) .. '}')
  end
  return 'null'
end

return steps[step]()
