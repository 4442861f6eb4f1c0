/**
 * A first script in Python, to copy. The displayed text masks the key, because a projector may show
 * it.
 */
import { Download } from "lucide";
import { useState } from "react";
import { useTranslation } from "react-i18next";
import { CodeField } from "../../ui/CodeField.tsx";
import { CopyButton } from "../../ui/CopyButton.tsx";
import { maskKey, type RobotAddress } from "../../model/remote/robot-address.ts";
import { starterLines, starterScript } from "./snippets.ts";
import { Icon } from "../../ui/Icon.tsx";
import panel from "./remote.module.css";
import styles from "./starter-script.module.css";

export function StarterScript({ address }: { address: RobotAddress }) {
  const { t, ready } = useTranslation(["words", "watch"], { useSuspense: false });
  const [isRefused, setRefused] = useState(false);
  const full = starterScript(address.full);
  const masked = starterScript(address.full.replace(address.key, maskKey(address.key)));
  return (
    <section className={panel["section"]} aria-labelledby="starter-heading">
      <div className={panel["bar"]}>
        <h2 id="starter-heading" className={panel["heading"]}>
          {t("remote.python")}
        </h2>
        <a className={styles["library"]} href="/corridor.py" download="corridor.py">
          <Icon of={Download} size={16} />
          {t("remote.library")}
        </a>
        <CopyButton
          text={full}
          label={t("remote.copyScript")}
          done={t("remote.copied")}
          kind="quiet"
          size="small"
          onRefused={() => setRefused(true)}
        />
      </div>
      <CodeField
        label={t("remote.script")}
        lines={starterLines}
        text={(isRefused ? full : masked).trimEnd()}
      />
      <p className={panel["note"]}>
        {isRefused ? t("remote.copyByHand") : t("remote.libraryNote")}
      </p>
      {/* Opens in a new tab: leaving this page ends the robot. */}
      <p className={styles["learn"]}>
        {ready && (
          <a className={styles["library"]} href="/docs" target="_blank" rel="noopener">
            {t("watch:learn")}
          </a>
        )}
      </p>
    </section>
  );
}
