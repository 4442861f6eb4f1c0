import { LanguageButton } from "../features/language/LanguageButton.tsx";
import { ThemeButton } from "../features/theme/ThemeButton.tsx";
import type { ScreenStore } from "../model/screen/screen-store.ts";

/** Theme and language, for the page and for that of a viewer. */
export function PageTools({ screen }: { screen: ScreenStore }) {
  return (
    <>
      <ThemeButton screen={screen} />
      <LanguageButton />
    </>
  );
}
