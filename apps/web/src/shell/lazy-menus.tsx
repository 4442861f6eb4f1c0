/** Content of menus that several places of the page contain. It loads when a menu opens. */
import { lazyPart } from "../ui/lazy-part.tsx";

export const FileItems = lazyPart(async () => (await import("./FileItems.tsx")).FileItems);

const AlgorithmCards = lazyPart(
  async () => (await import("../features/program-editor/AlgorithmCards.tsx")).AlgorithmCards,
);

/** The preset algorithms for the panel of the presets. */
export function algorithms(onChosen: (() => void) | undefined) {
  return <AlgorithmCards onChosen={onChosen} />;
}
