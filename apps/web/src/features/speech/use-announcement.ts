import { useEffect } from "react";
import { useServices } from "../../app/services.ts";

/**
 * Announces a state whenever it changes; null while there is nothing to announce.
 * @param about names the subject; newer news about it replace pending ones
 */
export function useSay(text: string | null, about: string): void {
  const { speech } = useServices();
  useEffect(() => speech.tellState(about, text), [speech, text, about]);
}
