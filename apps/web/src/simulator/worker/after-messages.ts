/**
 * Splits work between messages.
 * @returns a function that has `call` called after the messages that are already queued
 */
export function afterMessages(call: () => void): () => void {
  const { port1, port2 } = new MessageChannel();
  port1.onmessage = call;
  return () => port2.postMessage(null);
}
