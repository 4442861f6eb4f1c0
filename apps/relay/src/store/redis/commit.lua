-- Changes one robot, unless it has changed since its caller loaded it. Knows no rule of commands.
--
-- KEYS:
-- 1 the session, with its version
-- 2 open commands by seq
-- 3 a sorted set that may have to lack a member
-- then the other keys of the changes
-- ARGV:
-- 1 the version on which the changes are based; '' for a new robot, '*' to load the robot only
-- 2 the version after the changes, which is used once
-- 3 the member that the sorted set must not contain; '' for none
-- then the changes: each is a Redis command, after the number of its words
--
-- Returns the outcome: 'done', or 'stale' or 'present', followed by the current robot, if nothing was
-- changed.
--
-- Redis does not roll back. The first write is one that Redis rejects if its memory is full, so that
-- all changes are rejected.
local expected, version, absent = ARGV[1], ARGV[2], ARGV[3]
local FIRST = 4

local function unchanged(outcome)
  local fields = { 'version', 'epoch', 'seq', 'n', 'keys', 'blocked', 'paused', 'mayReset' }
  return { outcome, redis.call('HMGET', KEYS[1], unpack(fields)), redis.call('HVALS', KEYS[2]) }
end

if (redis.call('HGET', KEYS[1], 'version') or '') ~= expected then return unchanged('stale') end
if absent ~= '' and redis.call('ZSCORE', KEYS[3], absent) then return unchanged('present') end
if ARGV[FIRST] then redis.call('HSET', KEYS[1], 'version', version) end
local at = FIRST
while ARGV[at] do
  local last = at + ARGV[at]
  redis.call(unpack(ARGV, at + 1, last))
  at = last + 1
end
return { 'done' }
