/**
 * What a first script does not need: key, code, watch link, scripts by name, and the log.
 */
import { ChevronRight } from "lucide";
import { useEffect, useRef, useState } from "react";
import { useTranslation } from "react-i18next";
import type { RemoteSession } from "../../simulator/protocol/worker-messages.ts";
import { CommandLog } from "./CommandLog.tsx";
import { KeyField } from "./KeyField.tsx";
import { KeyList } from "./KeyList.tsx";
import { PairingField } from "./PairingField.tsx";
import { ScriptList } from "./ScriptList.tsx";
import { WatchField } from "./WatchField.tsx";
import { Icon } from "../../ui/Icon.tsx";
import panel from "./remote.module.css";
import fields from "./fields.module.css";
import styles from "./remote-more.module.css";

interface RemoteMoreProps {
  /** null while scripts cannot reach the robot: then only the log is displayed */
  session: RemoteSession | null;
}

export function RemoteMore({ session }: RemoteMoreProps) {
  const { t } = useTranslation();
  const [isOpen, setOpen] = useState(false);
  const details = useRef<HTMLDetailsElement>(null);
  // In a full panel the content opens below the visible part.
  useEffect(() => {
    if (isOpen) details.current?.scrollIntoView({ block: "start" });
  }, [isOpen]);
  return (
    <details
      ref={details}
      className={styles["more"]}
      open={isOpen}
      onToggle={(event) => setOpen(event.currentTarget.open)}
    >
      <summary className={styles["summary"]}>
        <Icon of={ChevronRight} isDirectional size={18} />
        <span className={styles["summaryWords"]}>
          <span className={panel["heading"]}>{t("remote.more")}</span>
          <span className={panel["note"]}>{t("remote.moreNote")}</span>
        </span>
      </summary>
      {isOpen && session !== null && (
        <div className={panel["section"]}>
          <dl className={fields["fields"]}>
            <KeyField session={session} />
            <PairingField session={session} />
            <WatchField session={session} />
          </dl>
        </div>
      )}
      {isOpen && session !== null && <ScriptList session={session} />}
      {isOpen && session !== null && <KeyList session={session} />}
      {isOpen && <CommandLog />}
    </details>
  );
}
