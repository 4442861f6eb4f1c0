-- Documents behind short links. Each step is one run of this script.
-- KEYS[1]: ids by last use. The script builds the names of the other keys.
local step, given = ARGV[1], cjson.decode(ARGV[2])
local uses = KEYS[1]

local function document(id) return 'corridor:document:' .. id end
local function keys(id) return 'corridor:document:' .. id .. ':keys' end
local function byHash(hash) return 'corridor:document-by-hash:' .. hash end

local function used(id, now)
  redis.call('ZADD', uses, 'GT', now, id)
end

local function remove(id)
  local hash = redis.call('HGET', document(id), 'hash')
  redis.call('DEL', document(id), keys(id), byHash(hash))
  redis.call('ZREM', uses, id)
end

local steps = {}

function steps.add()
  local id = redis.call('GET', byHash(given.hash))
  if not id then
    for _, candidate in ipairs(given.ids) do
      if redis.call('EXISTS', document(candidate)) == 0 then
        id = candidate
        break
      end
    end
    if not id then return redis.error_reply('all candidate ids are in use') end
    redis.call('SET', byHash(given.hash), id)
    redis.call('HSET', document(id), 'hash', given.hash, 'text', given.text)
  end
  redis.call('SADD', keys(id), given.keyHash)
  used(id, given.now)
  return cjson.encode(id)
end

function steps.use()
  local last = redis.call('ZSCORE', uses, given.id)
  if last and tonumber(last) < given.before then used(given.id, given.now) end
  return 'null'
end

function steps.remove()
  if redis.call('EXISTS', document(given.id)) == 0 then return '"no-document"' end
  if redis.call('SREM', keys(given.id), given.keyHash) == 0 then return '"wrong-key"' end
  if redis.call('SCARD', keys(given.id)) == 0 then remove(given.id) end
  return '"removed"'
end

function steps.removeUnused()
  local ids = redis.call('ZRANGE', uses, '-inf', '(' .. given.before, 'BYSCORE', 'LIMIT', 0, given.most)
  for _, id in ipairs(ids) do remove(id) end
  return tostring(#ids)
end

return steps[step]()
