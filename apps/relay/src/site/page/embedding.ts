/**
 * What embedding adds to the page: only `/embed` may be shown in a frame, and short links name their
 * description for embedding sites (oEmbed).
 */
import { shortLinkIdSchema } from "@corridor/protocol";
import { Router } from "express";
import type { RequestGuard } from "../../platform/http/request-guard.ts";
import { allowFraming } from "../../platform/http/security-headers.ts";

/** Paths of the page for frames. */
export const EMBED_PATHS = ["/embed", "/embed/m/:id"];

/** @param origins sites that may show the page in a frame; null: all */
export function embeddingHeaders(guard: RequestGuard, origins: readonly string[] | null): Router {
  const router = Router();
  router.get(EMBED_PATHS, (_request, response, next) => {
    allowFraming(response, origins);
    next();
  });
  router.get("/m/:id", (request, response, next) => {
    const { id } = request.params;
    if (shortLinkIdSchema.safeParse(id).success) {
      const origin = guard.originOf(request);
      const query = new URLSearchParams({ url: `${origin}/m/${id}` });
      const target = `${origin}/api/v1/oembed?${query.toString()}`;
      response.append("Link", `<${target}>; rel="alternate"; type="application/json+oembed"`);
    }
    next();
  });
  return router;
}
