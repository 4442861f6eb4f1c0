/** The robot's keys, with the times of their creation and last use, and buttons to revoke them. */
import { useEffect, useId, useRef, useState } from "react";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { useServices } from "../../model/use-services.ts";
import { joinList } from "../../text/joined.ts";
import { Button } from "../../ui/Button.tsx";
import type { RemoteSession } from "../../simulator/protocol/worker-messages.ts";
import { agoText } from "./ago-text.ts";
import { listKeys, revokeKey, type ListedKey } from "./key-calls.ts";
import { pairingOf } from "./robot-pairing.ts";
import { dropUrlKey, tabStorage } from "./url-key.ts";
import panel from "./remote.module.css";
import rows from "./list-rows.module.css";

const LOOK_EVERY_MS = 20_000;

export function KeyList({ session }: { session: RemoteSession }) {
  const { t } = useTranslation();
  const { keys, lookAgain } = useKeys(session);
  const heading = useRef<HTMLHeadingElement>(null);
  const [outcome, setOutcome] = useState<"done" | "failed" | null>(null);
  const revoke = async ({ id }: ListedKey): Promise<void> => {
    const isDone = await revokeKey(fetch, session, id);
    if (isDone) dropUrlKey(tabStorage, id);
    setOutcome(isDone ? "done" : "failed");
    lookAgain();
    // The pressed button disappears with its row.
    if (isDone) heading.current?.focus();
  };
  if (keys === null) return null;
  return (
    <section className={panel["section"]} aria-labelledby="keys-heading">
      <h2 id="keys-heading" ref={heading} tabIndex={-1} className={panel["heading"]}>
        {t("remote.keys.title")}
      </h2>
      <ul className={rows["rows"]}>
        {keys.map((key) => (
          <KeyRow key={key.id} listed={key} onRevoke={() => void revoke(key)} />
        ))}
      </ul>
      <p className={panel["note"]}>
        <output>
          {outcome === "done" && t("remote.keys.revoked")}
          {outcome === "failed" && t("remote.actionFailed")}
        </output>
        {outcome === null && keys.length > 1 && t("remote.keys.note")}
      </p>
    </section>
  );
}

function KeyRow({ listed, onRevoke }: { listed: ListedKey; onRevoke: () => void }) {
  const { t, i18n } = useTranslation();
  const id = useId();
  const names = useScriptsOf(listed.id);
  const { kind, isForUrl, isShown, madeAgo, usedAgo } = listed;
  const what = isShown ? t("remote.keys.shown") : t(`remote.keys.${kind}`);
  const made = t("remote.keys.made", { when: agoText(madeAgo, i18n.language) });
  const used =
    usedAgo === null
      ? t("remote.keys.unused")
      : t("remote.keys.used", { when: agoText(usedAgo, i18n.language) });
  return (
    <li className={rows["row"]}>
      <div className={rows["words"]}>
        <p id={id} className={rows["name"]}>
          <bdi>{names.length === 0 ? what : joinList(t, names)}</bdi>
        </p>
        <p className={panel["note"]}>
          {joinList(t, [
            ...(names.length === 0 ? [] : [what]),
            ...(isForUrl ? [t("remote.keys.url")] : []),
            made,
            used,
          ])}
        </p>
      </div>
      {/* "New key" replaces the key in the address, which therefore has no revoke button. */}
      {!isShown && (
        <Button size="small" aria-describedby={id} onClick={onRevoke}>
          {t("remote.keys.revoke")}
        </Button>
      )}
    </li>
  );
}

/** The names of the known scripts that use a key. */
function useScriptsOf(key: string): string[] {
  const { remote } = useServices();
  const scripts = useStore(remote, (state) => state.scripts);
  return scripts.flatMap(({ driver, name }) => (driver === key && name !== null ? [name] : []));
}

/**
 * Requests the keys periodically, after each pairing and each change of the address's key, and on
 * `lookAgain`.
 */
function useKeys(session: RemoteSession) {
  const [keys, setKeys] = useState<ListedKey[] | null>(null);
  const [looks, setLooks] = useState(0);
  const { id, ownerKey, driverKey } = session;
  const pairing = useStore(pairingOf(session).store, ({ view }) => view.kind);
  useEffect(() => {
    let isOver = false;
    const look = async (): Promise<void> => {
      const found = await listKeys(fetch, { id, ownerKey, driverKey });
      if (!isOver && found !== null) setKeys(found);
    };
    void look();
    const timer = setInterval(() => void look(), LOOK_EVERY_MS);
    return () => {
      isOver = true;
      clearInterval(timer);
    };
  }, [id, ownerKey, driverKey, pairing, looks]);
  return { keys, lookAgain: () => setLooks(looks + 1) };
}
