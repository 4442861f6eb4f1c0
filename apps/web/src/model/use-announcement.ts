import { useEffect } from "react";
import { useServices } from "./use-services.ts";

/**
 * Announces a state whenever it changes; null while there is nothing to announce.
 * @param about names the subject; a newer text about it replaces a pending one
 */
export function useAnnouncement(text: string | null, about: string): void {
  const { speech } = useServices();
  useEffect(() => speech.announceState(about, text), [speech, text, about]);
}
