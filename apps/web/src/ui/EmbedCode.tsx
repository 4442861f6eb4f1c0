/** The HTML code that shows the shared content in a frame of another site. */
import { frameMarkup, frameSizes, type FrameSize } from "@corridor/protocol";
import { useId, useRef, useState } from "react";
import { useTranslation } from "react-i18next";
import { CopyButton } from "./CopyButton.tsx";
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
  const id = useId();
  const field = useRef<HTMLInputElement>(null);
  const [size, setSize] = useState<FrameSize>("medium");
  const [isByHand, setByHand] = useState(false);
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
      <div className={styles["row"]}>
        <label className="visually-hidden" htmlFor={id}>
          {t("code.field")}
        </label>
        <input
          id={id}
          ref={field}
          dir="ltr"
          className={styles["code"]}
          readOnly
          value={code}
          onFocus={(event) => event.target.select()}
        />
        <CopyButton
          text={code}
          label={t("code.copy")}
          done={t("code.copied")}
          kind="quiet"
          onRefused={() => {
            field.current?.focus();
            field.current?.select();
            setByHand(true);
          }}
        />
      </div>
      <output className={styles["note"]}>{isByHand ? t("code.byHand") : ""}</output>
    </section>
  );
}
