-- Robot sessions and the state of their commands. Each step is one run of this script, so that
-- several relays can share one Redis. session-store.ts documents the steps.
--
-- KEYS:
-- 1 the session
-- 2 open commands by seq
-- 3 ended commands by seq
-- 4 seq by idempotency key
-- 5 sessions by last use
-- 6 sessions by creation
-- 7 the robot's channel
-- 8 relays by the time until which they count as alive
--
-- Redis does not roll back. The first write of a step must be one that Redis rejects if its memory
-- is full, so that the whole step is rejected.
-- A command is a JSON object. Values that Lua would round, or does not need, are stored as text.
local step, given, relay = ARGV[1], cjson.decode(ARGV[2]), ARGV[3]
local SESSION, OPEN, ENDED, BY_KEY, USES, BIRTHS, LINE, RELAYS = unpack(KEYS)
local WAITS, HELD, RUNS = 'accepted', 'delivered', 'started'

-- commands that this step has changed, by seq, for the subscribers of the channel
local changed, added = {}, nil

local function list(rows)
  table.sort(rows, function(a, b) return a.seq < b.seq end)
  local texts = {}
  for i, row in ipairs(rows) do texts[i] = cjson.encode(row) end
  return '[' .. table.concat(texts, ',') .. ']'
end

local function keep(row)
  if row.state == WAITS or row.state == HELD or row.state == RUNS then
    redis.call('HSET', OPEN, row.seq, cjson.encode(row))
  else
    redis.call('ZADD', ENDED, row.seq, cjson.encode(row))
    redis.call('HDEL', OPEN, row.seq)
  end
end

local function change(row, state, reason)
  row.state = state
  if reason then row.reason = reason end
  keep(row)
  changed[row.seq] = row
  return row
end

local function open(wanted)
  local rows = {}
  for _, text in ipairs(redis.call('HVALS', OPEN)) do
    local row = cjson.decode(text)
    if wanted(row) then rows[#rows + 1] = row end
  end
  table.sort(rows, function(a, b) return a.seq < b.seq end)
  return rows
end

local function ended(from, to, ...)
  local rows = {}
  for i, text in ipairs(redis.call('ZRANGEBYSCORE', ENDED, from, to, ...)) do
    rows[i] = cjson.decode(text)
  end
  return rows
end

local function find(seq)
  local text = redis.call('HGET', OPEN, seq)
  if text then return cjson.decode(text) end
  return ended(seq, seq)[1]
end

local function waits(row) return row.state == WAITS end
local function overtakes(row) return row.stop or row.replace end

local function isLate(row)
  return row.deadline <= given.now or row.acceptedAt > given.now + given.tolerance
end

local function epoch() return tonumber(redis.call('HGET', SESSION, 'epoch') or -1) end

-- Whether a running relay other than this one is connected to the page.
local function isHeld()
  local page = redis.call('HGET', SESSION, 'page')
  local holder = page and cjson.decode(page).relay
  if not holder or holder == relay then return false end
  local clock = redis.call('TIME')
  local now = clock[1] * 1000 + math.floor(clock[2] / 1000)
  return tonumber(redis.call('ZSCORE', RELAYS, holder) or 0) >= now
end

local function keyOf(row) return row.driver .. ':' .. row.key end

-- Ends the accepted commands before a stop or a replacing command.
local function overtake(seq, isStop)
  local rows = open(function(row) return waits(row) and row.seq < seq end)
  local state, verb = 'superseded', 'replaced'
  if isStop then state, verb = 'cancelled', 'stopped' end
  local reason = 'Command ' .. seq .. ' ' .. verb .. ' this command.'
  for _, row in ipairs(rows) do change(row, state, reason) end
  return rows
end

-- Cancels an accepted command, or marks one that the robot has as recalled. Returns whether the
-- command has ended.
local function recall(row, reason)
  if waits(row) then return change(row, 'cancelled', reason) and true end
  row.recalled = row.recalled or reason
  keep(row)
  return false
end

-- delivered or started -> its ending. Returns nil if it was in neither state.
local function finish(ending)
  local row = find(ending.seq)
  if not row or (row.state ~= HELD and row.state ~= RUNS) then return nil, row end
  row.reason, row.pose, row.distance = ending.reason, ending.pose, ending.distance
  return change(row, ending.state)
end

local function forget(id)
  local base = 'corridor:{' .. id .. '}'
  redis.call('ZREM', USES, id)
  redis.call('ZREM', BIRTHS, id)
  -- The robot's pairing code, with the key names of pairings.lua.
  for _, hash in ipairs(redis.call('HMGET', base .. ':pairing', 'code', 'key')) do
    if hash then redis.call('DEL', 'corridor:pairing:' .. hash) end
  end
  redis.call('ZREM', 'corridor:pairings', id)
  redis.call('PUBLISH', base .. ':line', '{"kind":"over","from":"' .. relay .. '"}')
  return redis.call('DEL', base, base .. ':open', base .. ':ended', base .. ':keys', base .. ':pairing') > 0
end

-- Removes scripts from the blocked ones. Returns those that remain.
local function keepAway(stays)
  local before, kept = cjson.decode(redis.call('HGET', SESSION, 'away') or '[]'), {}
  for _, script in ipairs(before) do
    if stays(script) then kept[#kept + 1] = script end
  end
  if #kept < #before then
    redis.call('HSET', SESSION, 'away', #kept > 0 and cjson.encode(kept) or '[]')
  end
  return kept
end

local steps = {}

function steps.create()
  local at = given.createdAt
  redis.call('HSET', SESSION, 'epoch', 0, 'seq', 0, 'createdAt', at, 'keys', given.keys)
  redis.call('ZADD', USES, at, given.id)
  redis.call('ZADD', BIRTHS, at, given.id)
  for _, key in ipairs(cjson.decode(given.keys)) do redis.call('HSET', SESSION, 'made:' .. key.hash, at) end
  return 'null'
end

function steps.find()
  local epoch, createdAt, keys, away, paused, name =
    unpack(redis.call('HMGET', SESSION, 'epoch', 'createdAt', 'keys', 'away', 'paused', 'name'))
  if not epoch then return 'null' end
  return cjson.encode({ epoch = tonumber(epoch), createdAt = tonumber(createdAt), keys = keys,
    away = away or '[]', isPaused = paused == '1', page = name or '', lastUsedAt = tonumber(redis.call('ZSCORE', USES, given.id)) })
end

function steps.changeKeys()
  local text = redis.call('HGET', SESSION, 'keys')
  if not text then return '{"outcome":"no-session"}' end
  local removed, keys = {}, {}
  for _, hash in ipairs(given.remove) do removed[hash] = true end
  for _, key in ipairs(cjson.decode(text)) do
    if removed[key.hash] or key.kind == given.removeKind then removed[key.hash] = true
    else keys[#keys + 1] = key end
  end
  for _, key in ipairs(given.add) do keys[#keys + 1] = key end
  if #given.add > 0 and #keys > given.most then return '{"outcome":"full"}' end
  local now = cjson.encode(keys)
  redis.call('HSET', SESSION, 'keys', now)
  for hash in pairs(removed) do redis.call('HDEL', SESSION, 'made:' .. hash, 'used:' .. hash) end
  for _, key in ipairs(given.add) do redis.call('HSET', SESSION, 'made:' .. key.hash, given.now) end
  keepAway(function(script) return not removed[script.driver] end)
  redis.call('PUBLISH', LINE, '{"kind":"keys","from":"' .. relay .. '"}')
  local gone = {}
  for _, row in ipairs(open(function(row) return removed[row.driver] end)) do
    if recall(row, given.reason) then gone[#gone + 1] = row end
  end
  return '{"outcome":"changed","keys":' .. cjson.encode(now) .. ',"ended":' .. list(gone) .. '}'
end

function steps.changeAway()
  if redis.call('EXISTS', SESSION) == 0 then return '{"outcome":"no-session"}' end
  local isKnown = false
  local others = keepAway(function(script)
    return given.add ~= cjson.null or script.id ~= given.id
  end)
  if given.add ~= cjson.null then
    for _, script in ipairs(others) do isKnown = isKnown or script.id == given.id end
    if not isKnown then
      if #others >= given.most then return '{"outcome":"full"}' end
      others[#others + 1] = cjson.decode(given.add)
      redis.call('HSET', SESSION, 'away', cjson.encode(others))
    end
  end
  redis.call('PUBLISH', LINE, '{"kind":"keys","from":"' .. relay .. '"}')
  local gone = {}
  if given.add ~= cjson.null then
    for _, row in ipairs(open(function(row) return row.script == given.id end)) do
      if recall(row, given.reason) then gone[#gone + 1] = row end
    end
  end
  local away = cjson.encode(redis.call('HGET', SESSION, 'away') or '[]')
  return '{"outcome":"changed","away":' .. away .. ',"ended":' .. list(gone) .. '}'
end

function steps.pause()
  if redis.call('EXISTS', SESSION) == 0 then return 'null' end
  redis.call('HSET', SESSION, 'paused', given.isPaused and '1' or '0')
  redis.call('PUBLISH', LINE, '{"kind":"keys","from":"' .. relay .. '"}')
  local gone = {}
  if given.isPaused then
    for _, row in ipairs(open(function(row) return not row.stop end)) do
      if recall(row, given.reason) then gone[#gone + 1] = row end
    end
  end
  return list(gone)
end

function steps.keepMaze()
  if redis.call('EXISTS', SESSION) == 0 then return 'false' end
  redis.call('HSET', SESSION, 'maze', given.text)
  return 'true'
end

function steps.keyTimes()
  local texts = {}
  for i, key in ipairs(cjson.decode(redis.call('HGET', SESSION, 'keys') or '[]')) do
    local made, used = unpack(redis.call('HMGET', SESSION, 'made:' .. key.hash, 'used:' .. key.hash))
    -- The creation time of older keys is unknown. They get that of their robot.
    made = made or redis.call('HGET', SESSION, 'createdAt')
    texts[i] = cjson.encode({ hash = key.hash, createdAt = tonumber(made), lastUsedAt = used and tonumber(used) or cjson.null })
  end
  return '[' .. table.concat(texts, ',') .. ']'
end

function steps.touch()
  redis.call('ZADD', USES, 'XX', 'GT', given.now, given.id)
  local keys = redis.call('HGET', SESSION, 'keys') or ''
  for _, use in ipairs(given.keys) do
    local field = 'used:' .. use.hash
    local isKey = string.find(keys, '"' .. use.hash .. '"', 1, true)
    if isKey and use.at > tonumber(redis.call('HGET', SESSION, field) or 0) then
      redis.call('HSET', SESSION, field, use.at)
    end
  end
  return 'null'
end

function steps.remove()
  return tostring(forget(given.id))
end

function steps.removeExpired()
  local gone, seen = {}, {}
  for index, before in pairs({ [USES] = given.lastUsedAt, [BIRTHS] = given.createdAt }) do
    local ids = redis.call('ZRANGE', index, '-inf', '(' .. before, 'BYSCORE', 'LIMIT', 0, given.most)
    for _, id in ipairs(ids) do
      if not seen[id] then gone[#gone + 1] = cjson.encode(id) end
      seen[id] = true
      forget(id)
    end
  end
  return '[' .. table.concat(gone, ',') .. ']'
end

function steps.add()
  local seq, keys, away, paused = unpack(redis.call('HMGET', SESSION, 'seq', 'keys', 'away', 'paused'))
  if not seq then return '{"outcome":"no-session"}' end
  local row = given.row
  if not string.find(keys, '"' .. row.driver .. '"', 1, true) then return '{"outcome":"revoked"}' end
  if away and row.script ~= cjson.null and string.find(away, '"' .. row.script .. '"', 1, true) then
    return '{"outcome":"blocked"}'
  end
  if row.key ~= cjson.null then
    local known = redis.call('HGET', BY_KEY, keyOf(row))
    local earlier = known and find(known)
    if earlier then
      local outcome = earlier.command == row.command and 'duplicate' or 'conflict'
      return '{"outcome":"' .. outcome .. '","row":' .. cjson.encode(earlier) .. '}'
    end
  end
  if paused == '1' and not row.stop then return '{"outcome":"paused"}' end
  if row.deadline <= row.acceptedAt then return '{"outcome":"late"}' end
  row.seq = tonumber(seq) + 1
  local overtaken = {}
  if overtakes(row) then overtaken = overtake(row.seq, row.stop) end
  local waiting = open(function(other) return waits(other) and not overtakes(other) end)
  if not row.stop and #waiting >= given.maxWaiting then return '{"outcome":"full"}' end
  redis.call('HSET', SESSION, 'seq', row.seq)
  if row.key ~= cjson.null then redis.call('HSET', BY_KEY, keyOf(row), row.seq) end
  keep(row)
  added = row
  local old = row.seq - given.keep
  for _, each in ipairs(ended('-inf', old)) do
    if each.key ~= cjson.null then redis.call('HDEL', BY_KEY, keyOf(each)) end
  end
  redis.call('ZREMRANGEBYSCORE', ENDED, '-inf', old)
  return '{"outcome":"stored","row":' .. cjson.encode(row) .. ',"ended":' .. list(overtaken) .. '}'
end

function steps.deliver()
  if epoch() ~= given.epoch then return '[]' end
  local rows = open(function(row)
    return row.state == HELD or (waits(row) and not isLate(row))
  end)
  local free, due = given.window, {}
  for _, row in ipairs(rows) do
    if row.state == HELD and not overtakes(row) then free = free - 1 end
  end
  for _, row in ipairs(rows) do
    if waits(row) then
      if overtakes(row) or free > 0 then due[#due + 1] = row end
      free = free - 1
    end
  end
  for _, row in ipairs(due) do
    row.epoch = given.epoch
    change(row, HELD)
  end
  return list(due)
end

-- Same text as expiredReason of the protocol.
local function expiredReason(ttl)
  return string.format(
    "Not started within %g s: check that the robot's page is open, connected under Remote and not paused.",
    ttl / 1000
  )
end

function steps.expire()
  local late, due = {}, nil
  for _, row in ipairs(open(waits)) do
    if isLate(row) then
      late[#late + 1] = change(row, 'expired', expiredReason(row.ttl))
    elseif not due or row.deadline < due then
      due = row.deadline
    end
  end
  return '{"ended":' .. list(late) .. ',"next":' .. (due and cjson.encode(due) or 'null') .. '}'
end

function steps.cancel()
  local row = find(given.seq)
  if not row then return '{"outcome":"no-command"}' end
  if row.driver ~= given.driver then return '{"outcome":"not-yours"}' end
  local outcome = 'over'
  if waits(row) or row.state == HELD or row.state == RUNS then
    outcome = recall(row, given.reason) and 'cancelled' or 'delivered'
  end
  return '{"outcome":"' .. outcome .. '","row":' .. cjson.encode(row) .. '}'
end

function steps.start()
  local row = find(given.seq)
  if epoch() ~= given.epoch or not row or row.state ~= HELD then return 'null' end
  return cjson.encode(change(row, RUNS))
end

function steps.finish()
  local row, known
  if epoch() == given.epoch then row, known = finish(given.ending) else known = find(given.ending.seq) end
  if row then return '{"outcome":"ended","row":' .. cjson.encode(row) .. '}' end
  return '{"outcome":"over","row":' .. (known and cjson.encode(known) or 'null') .. '}'
end

function steps.abandon()
  if epoch() ~= given.epoch then return '[]' end
  if isHeld() then return 'null' end
  redis.call('HINCRBY', SESSION, 'epoch', 1)
  local rows = open(function(row) return not waits(row) end)
  for _, row in ipairs(rows) do change(row, 'cancelled', given.reason) end
  return list(rows)
end

function steps.takeOver()
  local before = epoch()
  if before < 0 then return 'null' end
  local isSettled = given.settled ~= cjson.null and given.settled >= before
  local now = redis.call('HINCRBY', SESSION, 'epoch', 1)
  local holder = '"epoch":' .. now .. ',"name":"' .. given.page .. '"}'
  redis.call('HSET', SESSION, 'page', '{"relay":"' .. relay .. '",' .. holder)
  redis.call('HSET', SESSION, 'name', given.page)
  redis.call('PUBLISH', LINE, '{"kind":"page","from":"' .. relay .. '",' .. holder)
  -- A page with later commands than this Redis saw one that lost its newest commands.
  if given.lastApplied > tonumber(redis.call('HGET', SESSION, 'seq')) then
    redis.call('HSET', SESSION, 'seq', given.lastApplied)
  end
  local refused = {}
  for _, ending in ipairs(given.endings) do
    local row, known = finish(ending)
    if not row and known and known.state ~= ending.state then refused[#refused + 1] = known end
  end
  -- The new page's robot has not moved for these commands.
  local function cancel(row, reason)
    row.pose = given.pose
    row.distance = given.pose ~= cjson.null and '0' or cjson.null
    change(row, 'cancelled', reason)
  end
  for _, row in ipairs(open(function(row) return row.state == HELD end)) do
    if row.seq <= given.lastApplied then change(row, RUNS)
    elseif not isSettled then cancel(row, given.left.delivered)
    elseif row.recalled then cancel(row, row.recalled)
    else change(row, WAITS) end
  end
  if given.fresh or not isSettled then
    for _, row in ipairs(open(function(row) return row.state == RUNS end)) do
      cancel(row, given.left.started)
    end
  end
  -- A delivered command may be accepted again now, although a stop or a replacement arrived after
  -- it.
  local later = ended('(' .. given.lastApplied, '+inf')
  for _, row in ipairs(open(function(row) return row.seq > given.lastApplied end)) do
    later[#later + 1] = row
  end
  local stop, replacement = 0, 0
  for _, row in ipairs(later) do
    if row.stop then stop = math.max(stop, row.seq) end
    if row.replace then replacement = math.max(replacement, row.seq) end
  end
  if stop > 0 then overtake(stop, true) end
  if replacement > 0 then overtake(replacement, false) end
  local rows = {}
  for _, row in pairs(changed) do rows[#rows + 1] = row end
  return '{"epoch":' .. now .. ',"changed":' .. list(rows) .. ',"refused":' .. list(refused) .. '}'
end

function steps.command()
  local row = find(given.seq)
  return row and cjson.encode(row) or 'null'
end

function steps.after()
  local rows = ended('(' .. given.seq, '+inf', 'LIMIT', 0, given.limit)
  for _, row in ipairs(open(function(row) return row.seq > given.seq end)) do rows[#rows + 1] = row end
  return list(rows)
end

function steps.open()
  return list(open(function() return true end))
end

function steps.recalled()
  local asked = {}
  for i, row in ipairs(open(function(each) return each.recalled and not waits(each) end)) do
    asked[i] = cjson.encode({ seq = row.seq, reason = row.recalled })
  end
  return '[' .. table.concat(asked, ',') .. ']'
end

local answer = steps[step]()
if next(changed) or added then
  local rows = {}
  for _, row in pairs(changed) do rows[#rows + 1] = row end
  local n = redis.call('HINCRBY', SESSION, 'n', 1)
  redis.call('PUBLISH', LINE, '{"kind":"step","n":' .. n .. ',"from":"' .. relay .. '","added":' ..
    (added and cjson.encode(added) or 'null') .. ',"changed":' .. list(rows) .. '}')
end
return answer
