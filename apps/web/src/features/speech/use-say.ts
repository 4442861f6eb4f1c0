/** Says how something stands each time that it changes; null while there is nothing to say of it. */
import { useEffect } from "react";
import { useServices } from "../../app/services.ts";

/** @param about names the thing: newer news of it take the place of older that wait */
export function useSay(text: string | null, about: string): void {
  const { speech } = useServices();
  useEffect(() => speech.tellState(about, text), [speech, text, about]);
}
