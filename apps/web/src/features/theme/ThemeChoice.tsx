/** Light, dark, or as the system. */
import { Monitor, Moon, Sun } from "lucide-react";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { useServices } from "../../app/services.ts";
import { Segmented } from "../../ui/Segmented.tsx";
import styles from "./theme.module.css";

export const themeIcons = {
  system: <Monitor aria-hidden="true" />,
  light: <Sun aria-hidden="true" />,
  dark: <Moon aria-hidden="true" />,
};

export function ThemeChoice() {
  const { t } = useTranslation();
  const { screen } = useServices();
  const theme = useStore(screen, (state) => state.theme);
  return (
    <div className={styles["choice"]}>
      <Segmented
        label={t("works.theme")}
        value={theme}
        options={[
          { value: "system", label: t("works.themeSystem") },
          { value: "light", label: t("works.themeLight") },
          { value: "dark", label: t("works.themeDark") },
        ]}
        onChange={(choice) => screen.setState({ theme: choice })}
      />
    </div>
  );
}
