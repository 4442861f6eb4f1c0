-- Deletes robots with all of their keys.
-- Follows expiry.lua. KEYS: 1 sessions by last use, 2 sessions by creation
local step, given, relay = ARGV[1], cjson.decode(ARGV[2]), ARGV[3]
local USES, BIRTHS = unpack(KEYS)

local function delete(id)
  local base = 'corridor:{' .. id .. '}'
  redis.call('ZREM', USES, id)
  redis.call('ZREM', BIRTHS, id)
  -- The robot's pairing code, with the key names of pairings.lua.
  for _, hash in ipairs(redis.call('HMGET', base .. ':pairing', 'code', 'key')) do
    if hash then redis.call('DEL', 'corridor:pairing:' .. hash) end
  end
  redis.call('ZREM', 'corridor:pairings', id)
  redis.call('PUBLISH', base .. ':channel', '{"kind":"over","from":"' .. relay .. '"}')
  return redis.call('DEL', base, base .. ':open', base .. ':ended', base .. ':keys', base .. ':pairing') > 0
end

local steps = {}

function steps.remove()
  return tostring(delete(given.id))
end

function steps.removeExpired()
  return removeExpired({ [USES] = given.lastUsedAt, [BIRTHS] = given.createdAt }, given.most, delete)
end

return steps[step]()
