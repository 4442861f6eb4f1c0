/** Light, dark or system theme, each with optional high contrast. */
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import type { ScreenStore } from "../../model/screen/screen-store.ts";
import { Checkbox } from "../../ui/Checkbox.tsx";
import { Segmented } from "../../ui/Segmented.tsx";
import { useMediaQuery } from "../../ui/use-media-query.ts";
import styles from "./theme.module.css";

export function ThemeChoice({ screen }: { screen: ScreenStore }) {
  const { t } = useTranslation();
  const theme = useStore(screen, (state) => state.theme);
  const contrast = useStore(screen, (state) => state.contrast);
  const isAsked = useMediaQuery("(prefers-contrast: more)");
  return (
    <div className={styles["choice"]}>
      <Segmented
        label={t("theme.label")}
        value={theme}
        options={[
          { value: "system", label: t("theme.system") },
          { value: "light", label: t("theme.light") },
          { value: "dark", label: t("theme.dark") },
        ]}
        onChange={(choice) => screen.setState({ theme: choice })}
      />
      <Checkbox
        label={t("theme.contrast")}
        note={t(isAsked ? "theme.contrastSystem" : "theme.contrastNote")}
        checked={isAsked || contrast === "more"}
        disabled={isAsked}
        onChange={(isOn) => screen.setState({ contrast: isOn ? "more" : "system" })}
      />
    </div>
  );
}
