/** A random id of an entry. crypto.randomUUID is not available in insecure contexts. */
export function newTextId(): string {
  const bytes = crypto.getRandomValues(new Uint8Array(12));
  return Array.from(bytes, (byte) => byte.toString(16).padStart(2, "0")).join("");
}
