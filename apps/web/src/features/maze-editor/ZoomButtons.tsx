/** Zoom out, whole maze, zoom in: below the maze, or in the View menu where the stage is small. */
import { Scan, ZoomIn, ZoomOut } from "lucide";
import { useTranslation } from "react-i18next";
import { useServices } from "../../model/use-services.ts";
import { Icon } from "../../ui/Icon.tsx";
import { IconButton } from "../../ui/Button.tsx";
import styles from "./zoom-buttons.module.css";

const buttons = [
  ["out", ZoomOut],
  ["fit", Scan],
  ["in", ZoomIn],
] as const;

export function ZoomButtons({ size }: { size: "small" | "large" }) {
  const { camera } = useServices();
  const { t, ready } = useTranslation("runDetails", { useSuspense: false });
  if (!ready) return null;
  return (
    <fieldset className={styles["buttons"]} aria-label={t("stageZoom.name")}>
      {buttons.map(([by, icon]) => (
        <IconButton
          key={by}
          size={size}
          label={t(`stageZoom.${by}`)}
          onClick={() => camera.getState().zoom(by, null)}
        >
          <Icon of={icon} />
        </IconButton>
      ))}
    </fieldset>
  );
}
