-- Classes. Each step is one run of this script.
-- Follows expiry.lua. KEYS: 1 classes by last use, 2 classes by creation. The script builds the names of the other keys.
local step, given = ARGV[1], cjson.decode(ARGV[2])
local USES, BIRTHS = KEYS[1], KEYS[2]

-- A hash: version, row, lesson, student:NUMBER, program:NUMBER, code:HASH (a code's student, or '').
local function class(id) return 'corridor:class:{' .. id .. '}' end
local function progress(id, student) return class(id) .. ':progress:' .. student end
local function channel(id) return class(id) .. ':channel' end
-- ID STUDENT ENDS, where STUDENT and ENDS may be '-'
local function byCode(hash) return 'corridor:class-code:' .. hash end

local function insertCode(id, code)
  local student, ends = tostring(code.student or '-'), tostring(code.endsAt or '-')
  redis.call('SET', byCode(code.hash), id .. ' ' .. student .. ' ' .. ends)
  redis.call('HSET', class(id), 'code:' .. code.hash, student)
end

local function deleteCode(id, hash)
  redis.call('DEL', byCode(hash))
  redis.call('HDEL', class(id), 'code:' .. hash)
end

local function fields(id, prefix)
  local found = {}
  for _, field in ipairs(redis.call('HKEYS', class(id))) do
    if string.sub(field, 1, #prefix) == prefix then
      found[#found + 1] = string.sub(field, #prefix + 1)
    end
  end
  return found
end

local function remove(id)
  for _, hash in ipairs(fields(id, 'code:')) do redis.call('DEL', byCode(hash)) end
  for _, student in ipairs(fields(id, 'student:')) do redis.call('DEL', progress(id, student)) end
  redis.call('ZREM', USES, id)
  redis.call('ZREM', BIRTHS, id)
  redis.call('PUBLISH', channel(id), '{"kind":"over"}')
  return redis.call('DEL', class(id)) > 0
end

local steps = {}

function steps.create()
  if redis.call('EXISTS', byCode(given.code.hash)) == 1 then return 'false' end
  -- Redis does not roll back. The first write is one that Redis rejects if its memory is full.
  redis.call('HSET', class(given.id), 'version', given.version, 'row', given.row, 'lesson', given.lesson)
  redis.call('ZADD', USES, given.createdAt, given.id)
  redis.call('ZADD', BIRTHS, given.createdAt, given.id)
  insertCode(given.id, given.code)
  return 'true'
end

function steps.load()
  local row = redis.call('HGET', class(given.id), 'row')
  if not row then return 'null' end
  local students = {}
  for _, student in ipairs(fields(given.id, 'student:')) do
    students[#students + 1] = redis.call('HGET', class(given.id), 'student:' .. student)
  end
  return cjson.encode({ row = row, students = table.concat(students, ',') })
end

function steps.commit()
  local id = given.id
  local version = redis.call('HGET', class(id), 'version')
  if not version then return '"no-class"' end
  if tonumber(version) ~= given.expected then return '"conflict"' end
  for _, code in ipairs(given.newCodes) do
    if redis.call('EXISTS', byCode(code.hash)) == 1 then return '"code-taken"' end
  end
  redis.call('HSET', class(id), 'version', given.version, 'row', given.row)
  if given.lesson then redis.call('HSET', class(id), 'lesson', given.lesson) end
  for _, each in ipairs(given.students) do
    redis.call('HSET', class(id), 'student:' .. each.student, each.text)
  end
  for _, each in ipairs(given.progress) do
    redis.call('RPUSH', progress(id, each.student), each.text)
  end
  for _, each in ipairs(given.programs) do
    redis.call('HSET', class(id), 'program:' .. each.student, each.text)
  end
  for _, hash in ipairs(given.oldCodes) do deleteCode(id, hash) end
  for _, student in ipairs(given.removed) do
    redis.call('HDEL', class(id), 'student:' .. student, 'program:' .. student)
    redis.call('DEL', progress(id, student))
    for _, hash in ipairs(fields(id, 'code:')) do
      if redis.call('HGET', class(id), 'code:' .. hash) == tostring(student) then
        deleteCode(id, hash)
      end
    end
  end
  for _, code in ipairs(given.newCodes) do insertCode(id, code) end
  redis.call('PUBLISH', channel(id), given.message)
  return '"committed"'
end

function steps.progress()
  local lists = {}
  for _, student in ipairs(fields(given.id, 'student:')) do
    local texts = redis.call('LRANGE', progress(given.id, student), 0, -1)
    if #texts > 0 then lists[#lists + 1] = { student = student, texts = texts } end
  end
  if #lists == 0 then return '[]' end
  return cjson.encode(lists)
end

function steps.touch()
  redis.call('ZADD', USES, 'XX', 'GT', given.now, given.id)
  return 'null'
end

function steps.remove()
  return tostring(remove(given.id))
end

function steps.removeExpired()
  return removeExpired({ [USES] = given.lastUsedAt, [BIRTHS] = given.createdAt }, given.most, remove)
end

return steps[step]()
