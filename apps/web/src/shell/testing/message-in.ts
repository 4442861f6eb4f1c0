/**
 * The newest message to the user. Read from its store, because it disappears from the screen after
 * some seconds, which a slow machine may take for a click.
 */
import type { Message, ScreenStore } from "../../model/screen/screen-store.ts";

export function messageIn(screen: ScreenStore): Message {
  const [message] = screen.getState().messages;
  if (message === undefined) throw new Error("There is no message.");
  return message;
}
