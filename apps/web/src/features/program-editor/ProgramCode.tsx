/**
 * The program as a script that drives through the same poses. It follows each edit. The displayed
 * text masks the key, because a projector may show it.
 */
import { codeFiles, codeLanguages, programCode, type CodeLanguage } from "@corridor/program";
import { Download } from "lucide";
import { useEffect, useLayoutEffect, useRef, useState } from "react";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { maskKey, robotAddress } from "../../model/remote/robot-address.ts";
import { useServices } from "../../model/use-services.ts";
import { Button } from "../../ui/Button.tsx";
import { CodeField } from "../../ui/CodeField.tsx";
import { CopyButton } from "../../ui/CopyButton.tsx";
import { Icon } from "../../ui/Icon.tsx";
import { saveFile } from "../../ui/save-file.ts";
import { Segmented } from "../../ui/Segmented.tsx";
import styles from "./program-code.module.css";

const names = { python: "Python", javascript: "JavaScript", java: "Java", csharp: "C#" } as const;
const options = codeLanguages.map((value) => ({ value, label: names[value] }));

const SHOWN_LINES = 10;

export function ProgramCode() {
  const { t, ready } = useTranslation(["words", "code"], { useSuspense: false });
  const { workspace, remote, connection } = useServices();
  const [language, setLanguage] = useState<CodeLanguage>("python");
  const [isRefused, setRefused] = useState(false);
  const section = useRef<HTMLDivElement>(null);
  const program = useStore(workspace, (state) => state.program);
  const session = useStore(remote, (state) => state.session);
  // The script needs the address of a robot, which this page may not have yet.
  useEffect(() => {
    const { session: own, status } = remote.getState();
    if (own === null && status.kind === "off") connection.open();
  }, [remote, connection]);
  // On a phone, the button stands on the lower edge of the sheet, and the code opens below.
  useLayoutEffect(() => {
    section.current?.scrollIntoView({ block: "nearest" });
  }, [ready]);
  if (!ready) return null;
  const address = session === null ? null : robotAddress(session);
  const full = address?.full ?? `${location.origin}/r/ID#KEY`;
  const masked = address === null ? full : full.replace(address.key, maskKey(address.key));
  const copied = programCode(program, language, full);
  const displayed = programCode(program, language, isRefused ? full : masked);
  const { file, command, needs } = codeFiles[language];
  return (
    <div ref={section} className={styles["section"]}>
      {copied.ok && displayed.ok ? (
        <>
          <Segmented
            label={t("remote.scriptLanguage")}
            value={language}
            options={options}
            onChange={setLanguage}
          />
          <div className={styles["bar"]}>
            <CopyButton
              text={copied.text}
              label={t("remote.copyScript")}
              done={t("remote.copied")}
              kind="quiet"
              size="small"
              onRefused={() => setRefused(true)}
            />
            <Button
              kind="quiet"
              size="small"
              icon={<Icon of={Download} />}
              onClick={() => saveFile(new Blob([copied.text], { type: "text/plain" }), file)}
            >
              {t("code:save", { file })}
            </Button>
          </div>
          <CodeField label={t("code:title")} lines={SHOWN_LINES} text={displayed.text} />
          <p className={styles["note"]}>
            {t("code:same", { remote: t("drive.remote") })}{" "}
            {address === null
              ? t("code:noAddress")
              : t(isRefused ? "remote.copyByHand" : "remote.scriptNote", { file, command })}{" "}
            {t("remote.scriptNeeds", { program: needs })}
          </p>
        </>
      ) : (
        <p className={styles["note"]}>{t("code:tooMany")}</p>
      )}
    </div>
  );
}
