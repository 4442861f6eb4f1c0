/** Caches a function's results for ever. For few keys that are requested many times a second. */
export function memoize<Key, Value>(compute: (question: Key) => Value): (question: Key) => Value {
  const cache = new Map<Key, Value>();
  return (key) => {
    if (cache.has(key)) return cache.get(key) as Value;
    const value = compute(key);
    cache.set(key, value);
    return value;
  };
}
