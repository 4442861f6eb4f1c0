/** Opens the pages without a robot: of viewers, teachers, classes, joining students and other sites. */
import type { OpenPage, PageParts } from "../model/page-parts.ts";
import { PageTools } from "./PageTools.tsx";

/**
 * @param path one that `OTHER_PAGE` of the entry names
 * @throws if a file of the page does not load
 */
export async function openOtherPage(path: string, parts: Omit<PageParts, "tools">): Promise<void> {
  const { openPage } = await load(path);
  await openPage({ ...parts, tools: <PageTools screen={parts.screen} /> });
}

function load(path: string): Promise<{ openPage: OpenPage }> {
  if (path.startsWith("/r/")) return import("../features/watch/open-watch.tsx");
  if (path.startsWith("/class/")) return import("../features/dashboard/open-class-page.tsx");
  if (path.startsWith("/embed")) return import("./open-embed.tsx");
  if (path.startsWith("/join")) return import("../features/join/open-join.tsx");
  return import("./open-teach.tsx");
}
