/** The short link of the shared content: whether one is possible, and how to make and delete it. */
import type { ShortLink } from "@corridor/protocol";
import { useEffect, useState } from "react";
import { useOnline } from "../ui/use-online.ts";
import { storageOrNone } from "./storage/key-value-storage.ts";
import { ShortLinkService, type ShortLinkDocument } from "./address/short-link-service.ts";

export interface ShortLinkState {
  /** whether a service responds that makes short links; null until that is known */
  isOffered: boolean | null;
  /** the link of the exact document that is shared now; null if there is none */
  link: ShortLink | null;
  isBusy: boolean;
  /** result of the last press */
  outcome: "made" | "failed" | "deleted" | "notDeleted" | null;
  make: () => void;
  remove: () => void;
}

/** @param document must be the same object while its content is the same */
export function useShortLink(document: ShortLinkDocument): ShortLinkState {
  const [service] = useState(
    () =>
      new ShortLinkService(
        (url, init) => fetch(url, init),
        storageOrNone(() => localStorage),
      ),
  );
  const isOnline = useOnline();
  const [isOffered, setOffered] = useState<boolean | null>(null);
  const [made, setMade] = useState<ReadonlyMap<ShortLinkDocument, ShortLink>>(new Map());
  const [isBusy, setBusy] = useState(false);
  const [outcome, setOutcome] = useState<ShortLinkState["outcome"]>(null);
  useEffect(() => {
    if (!isOnline) return;
    let isOver = false;
    void service.answers().then((does) => {
      if (!isOver) setOffered(does);
    });
    return () => {
      isOver = true;
    };
  }, [service, isOnline]);
  const link = made.get(document) ?? null;

  async function make(): Promise<void> {
    setBusy(true);
    setOutcome(null);
    const answer = await service.make(document);
    if (answer !== null) setMade((before) => new Map(before).set(document, answer));
    setOutcome(answer === null ? "failed" : "made");
    setBusy(false);
  }

  async function remove({ id }: ShortLink): Promise<void> {
    setBusy(true);
    setOutcome(null);
    const isGone = await service.delete(id);
    if (isGone) setMade((before) => new Map([...before].filter(([, each]) => each.id !== id)));
    setOutcome(isGone ? "deleted" : "notDeleted");
    setBusy(false);
  }

  return {
    isOffered: isOnline ? isOffered : false,
    link,
    isBusy,
    outcome,
    // A second press, before or after the answer, changes nothing.
    make: () => {
      if (!isBusy && link === null) void make();
    },
    remove: () => {
      if (!isBusy && link !== null) void remove(link);
    },
  };
}
