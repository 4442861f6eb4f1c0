/**
 * The controls over the stage while the Drive tab of a phone is open: a button that switches
 * between the whole maze and the robot, and a small map while the camera shows only a part.
 */
import { LocateFixed, Scan } from "lucide";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { useServices } from "../../model/use-services.ts";
import { Icon } from "../../ui/Icon.tsx";
import { Button } from "../../ui/Button.tsx";
import { classNames } from "../../ui/class-names.ts";
import { lazyPart } from "../../ui/lazy-part.tsx";
import type { StageViewStore } from "../../stage/page/stage-view.ts";
import styles from "./camera-view.module.css";

const SmallMap = lazyPart(async () => (await import("./SmallMap.tsx")).SmallMap);

export function CameraView({ view }: { view: StageViewStore }) {
  const { t } = useTranslation();
  const { camera } = useServices();
  const isWhole = useStore(camera, (state) => state.isWhole);
  const follows = useStore(view, ({ layout }) => layout?.follows === true);
  // A maze that fits at the robot's scale is always displayed whole.
  if (!isWhole && !follows) return null;
  const icon = isWhole ? LocateFixed : Scan;
  return (
    <>
      <div className={classNames(styles["bar"], follows && styles["over"])}>
        <Button
          size="large"
          className={styles["look"]}
          icon={<Icon of={icon} />}
          onClick={() => camera.setState({ isWhole: !isWhole })}
        >
          {t(isWhole ? "phone.followRobot" : "phone.wholeMaze")}
        </Button>
      </div>
      {follows && <SmallMap view={view} />}
    </>
  );
}
