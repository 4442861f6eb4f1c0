/** The HTML code that shows the shared content in a frame of another site. */
import { frameMarkup, frameSizes, type FrameSize } from "@corridor/protocol";
import { useState } from "react";
import { useTranslation } from "react-i18next";
import { CopyField } from "./CopyField.tsx";
import styles from "./embed-code.module.css";
import { Segmented } from "./Segmented.tsx";

const sizes = Object.keys(frameSizes) as FrameSize[];

interface EmbedCodeProps {
  /** address of the frame, below `/embed` */
  address: string;
  /** name of the content */
  name: string;
}

export function EmbedCode({ address, name }: EmbedCodeProps) {
  const { t, ready } = useTranslation("embed", { useSuspense: false });
  const [size, setSize] = useState<FrameSize>("medium");
  if (!ready) return null;
  const code = frameMarkup({ address, title: name || "Corridor", ...frameSizes[size] });
  return (
    <section className={styles["embed"]} aria-label={t("code.title")}>
      <div className={styles["head"]}>
        <h3 className={styles["title"]}>{t("code.title")}</h3>
        <Segmented
          label={t("code.size")}
          value={size}
          options={sizes.map((value) => ({ value, label: t(`code.sizes.${value}`) }))}
          onChange={setSize}
        />
      </div>
      <CopyField
        look="code"
        label={t("code.field")}
        text={code}
        copy={t("code.copy")}
        copied={t("code.copied")}
        byHand={t("code.byHand")}
      />
    </section>
  );
}
