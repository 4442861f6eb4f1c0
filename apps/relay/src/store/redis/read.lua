-- Reads several keys at one moment. Unlike a transaction, it works while the memory of Redis is full.
-- KEYS: the keys of the commands
-- ARGV: Redis commands, each after the number of its words
-- Returns their replies.
local replies, at = {}, 1
while ARGV[at] do
  local last = at + ARGV[at]
  replies[#replies + 1] = redis.call(unpack(ARGV, at + 1, last))
  at = last + 1
end
return replies
