-- Pairing codes. Each step is one run of this script.
-- KEYS: 1 robots by the expiry of their code. The script builds the names of the other keys.
-- deletion.lua deletes the code of a deleted robot and uses the same names.
local step, given = ARGV[1], cjson.decode(ARGV[2])
local ENDS = KEYS[1]

local function session(robot) return 'corridor:{' .. robot .. '}' end
local function pairing(robot) return session(robot) .. ':pairing' end
-- by the hash of the code, or of the requesting script's key
local function byHash(hash) return 'corridor:pairing:' .. hash end

local function remove(robot)
  for _, hash in ipairs(redis.call('HMGET', pairing(robot), 'code', 'key')) do
    if hash then redis.call('DEL', byHash(hash)) end
  end
  redis.call('ZREM', ENDS, robot)
  return redis.call('DEL', pairing(robot)) > 0
end

-- The robot of the pairing that is looked for.
local function robotOf()
  return given.robot or redis.call('GET', byHash(given.hash))
end

local steps = {}

function steps.open()
  if redis.call('EXISTS', session(given.robot)) == 0 then return '"no-robot"' end
  local holder = redis.call('GET', byHash(given.code))
  if holder and holder ~= given.robot then return '"taken"' end
  -- Redis does not roll back. The first write is one that Redis rejects if its memory is full.
  redis.call('ZADD', ENDS, given.endsAt, given.robot)
  remove(given.robot)
  redis.call('ZADD', ENDS, given.endsAt, given.robot)
  redis.call('SET', byHash(given.code), given.robot)
  redis.call('HSET', pairing(given.robot), 'code', given.code, 'endsAt', given.endsAt, 'state', 'open')
  return '"opened"'
end

function steps.find()
  local robot = robotOf()
  if not robot then return 'null' end
  local code, ends, state, question =
    unpack(redis.call('HMGET', pairing(robot), 'code', 'endsAt', 'state', 'question'))
  if not code or tonumber(ends) <= given.now then return 'null' end
  return cjson.encode({ robot = robot, code = code, endsAt = tonumber(ends), state = state,
    question = question or 'null' })
end

function steps.transition()
  local robot = robotOf()
  if not robot then return 'false' end
  local state, ends = unpack(redis.call('HMGET', pairing(robot), 'state', 'endsAt'))
  if state ~= given.from or tonumber(ends) <= given.now then return 'false' end
  -- The first write is one that Redis rejects if its memory is full.
  if given.key then
    redis.call('SET', byHash(given.key), robot)
    redis.call('HSET', pairing(robot), 'key', given.key, 'question', given.question)
  end
  redis.call('HSET', pairing(robot), 'state', given.to)
  return 'true'
end

function steps.remove()
  return tostring(remove(given.robot))
end

function steps.removeEnded()
  local robots = redis.call('ZRANGE', ENDS, '-inf', given.now, 'BYSCORE', 'LIMIT', 0, given.most)
  for _, robot in ipairs(robots) do remove(robot) end
  return tostring(#robots)
end

return steps[step]()
