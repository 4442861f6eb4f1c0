/** What every answer tells the browser about its rights, and who may read the API. */
import type { RequestHandler, Response } from "express";
import helmet from "helmet";

const SELF = "'self'";

/**
 * Content-Security-Policy and its companions: nothing but what this service itself serves.
 * @param isDevelopment hot reload puts its own scripts and styles into the page
 */
export function securityHeaders(isDevelopment: boolean): RequestHandler {
  const own = isDevelopment ? [SELF, "'unsafe-inline'"] : [SELF];
  return helmet({
    contentSecurityPolicy: {
      useDefaults: false,
      directives: {
        defaultSrc: [SELF],
        scriptSrc: own,
        styleSrc: own,
        // 'self' covers the WebSocket of the same host too.
        connectSrc: [SELF],
        workerSrc: [SELF],
        manifestSrc: [SELF],
        imgSrc: [SELF, "data:", "blob:"],
        fontSrc: [SELF],
        formAction: [SELF],
        objectSrc: ["'none'"],
        baseUri: ["'none'"],
        frameAncestors: ["'none'"],
        // No text becomes markup or script; the page's one policy names the workers that may be started.
        ...(!isDevelopment && {
          requireTrustedTypesFor: ["'script'"],
          trustedTypes: ["default"],
        }),
      },
    },
    referrerPolicy: { policy: "no-referrer" },
    // Whether there is HTTPS is known to the proxy in front, not here.
    strictTransportSecurity: false,
    xFrameOptions: { action: "deny" },
  });
}

/** Lets a page have one more policy of Trusted Types, which a library of its makes. */
export function allowPolicy(response: Response, name: string): void {
  const header = "Content-Security-Policy";
  const policy = String(response.getHeader(header));
  response.set(header, policy.replace("trusted-types default", `trusted-types default ${name}`));
}

/** Scripts on any site may call the API: rights come from the key alone, never from a cookie. */
export const openToAllSites: RequestHandler = (request, response, next) => {
  response.set({
    "Access-Control-Allow-Origin": "*",
    "Access-Control-Expose-Headers": "ETag, Location, Retry-After",
    "Cross-Origin-Resource-Policy": "cross-origin",
    "Cache-Control": "no-store",
  });
  if (request.method !== "OPTIONS") return next();
  response
    .set({
      "Access-Control-Allow-Methods": "GET, POST, PUT, DELETE",
      "Access-Control-Allow-Headers":
        "Authorization, Content-Type, Idempotency-Key, If-None-Match, Last-Event-ID, Script-Clock, Script-Name",
      "Access-Control-Max-Age": "86400",
    })
    .status(204)
    .end();
  return undefined;
};
