/** Holds a card at the upper end of the panel or the sheet if the stage has no room for it. */
import { useCallback } from "react";
import { useServices } from "../../model/use-services.ts";

export function CardDock() {
  const { cardDock } = useServices();
  const hold = useCallback(
    (element: HTMLElement | null) => cardDock.setState({ element }),
    [cardDock],
  );
  return <div ref={hold} />;
}
