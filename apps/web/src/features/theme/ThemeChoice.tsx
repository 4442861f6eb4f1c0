/** Light, dark or system theme, each with optional high contrast. */
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import type { ScreenStore } from "../../stores/screen-store.ts";
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
        label={t("projects.theme")}
        value={theme}
        options={[
          { value: "system", label: t("projects.themeSystem") },
          { value: "light", label: t("projects.themeLight") },
          { value: "dark", label: t("projects.themeDark") },
        ]}
        onChange={(choice) => screen.setState({ theme: choice })}
      />
      <Checkbox
        label={t("projects.contrast")}
        note={t(isAsked ? "projects.contrastSystem" : "projects.contrastNote")}
        checked={isAsked || contrast === "more"}
        disabled={isAsked}
        onChange={(isOn) => screen.setState({ contrast: isOn ? "more" : "system" })}
      />
    </div>
  );
}
