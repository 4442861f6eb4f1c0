-- What relays know of each other besides the steps of the store. Time is that of Redis alone.
-- KEYS: 1 the robot's session, 2 its line, 3 the relays by the time until which they count as alive.
local step, given, relay = ARGV[1], cjson.decode(ARGV[2]), ARGV[3]
local SESSION, LINE, RELAYS = unpack(KEYS)
local clock = redis.call('TIME')
local now = clock[1] * 1000 + math.floor(clock[2] / 1000)

local steps = {}

-- This relay lives. Returns all that do.
function steps.beat()
  redis.call('ZADD', RELAYS, now + given.ms, relay)
  redis.call('ZREMRANGEBYSCORE', RELAYS, '-inf', '(' .. now)
  return cjson.encode(redis.call('ZRANGE', RELAYS, 0, -1))
end

function steps.stop()
  redis.call('ZREM', RELAYS, relay)
  return 'null'
end

-- Who is the robot's page, where its relay lives.
function steps.holder()
  local page = redis.call('HGET', SESSION, 'page')
  if not page then return 'null' end
  local holder = cjson.decode(page)
  local alive = tonumber(redis.call('ZSCORE', RELAYS, holder.relay) or 0)
  return alive >= now and page or 'null'
end

-- The page with this epoch is away.
function steps.left()
  local page = redis.call('HGET', SESSION, 'page')
  if page and cjson.decode(page).epoch == given.epoch then
    redis.call('HDEL', SESSION, 'page')
    redis.call('PUBLISH', LINE,
      '{"kind":"page-left","from":"' .. relay .. '","epoch":' .. given.epoch .. '}')
  end
  return 'null'
end

return steps[step]()
