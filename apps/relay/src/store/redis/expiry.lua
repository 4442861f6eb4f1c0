-- Deletes what has expired: robots and classes. Other scripts follow in the same text.

-- before: by the name of an index, the time before which its members expire. remove: deletes one.
-- Returns the deleted ids as JSON.
local function removeExpired(before, most, remove)
  local gone, seen = {}, {}
  for index, time in pairs(before) do
    local ids = redis.call('ZRANGE', index, '-inf', '(' .. time, 'BYSCORE', 'LIMIT', 0, most)
    for _, id in ipairs(ids) do
      if not seen[id] then gone[#gone + 1] = cjson.encode(id) end
      seen[id] = true
      remove(id)
    end
  end
  return '[' .. table.concat(gone, ',') .. ']'
end
