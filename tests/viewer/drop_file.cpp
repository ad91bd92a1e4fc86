// drop_file WINDOW FILE: drops a file onto an X11 window as a file manager does, by XDND version 5
// (freedesktop.org's specification). Exits 0 once the window reports that it has taken it.

#include <chrono>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <iostream>
#include <string>
#include <thread>
#include <X11/Xatom.h>
#include <X11/Xlib.h>

namespace {

/// A drag: the dropped file, and the program's own window as its source.
class Drag {
  public:
    Drag(Display* display, Window target, const std::string& file)
        : display_(display), target_(target), text_("file://" + file + "\r\n"),
          source_(XCreateSimpleWindow(display, DefaultRootWindow(display), 0, 0, 1, 1, 0, 0, 0)) {
        XSetSelectionOwner(display_, atom("XdndSelection"), source_, CurrentTime);
    }

    bool dropIt() {
        send("XdndEnter", 5l << 24, static_cast<long>(atom("text/uri-list")), 0, 0);
        send("XdndPosition", 0, middle(), CurrentTime, static_cast<long>(atom("XdndActionCopy")));
        if (!(waitFor("XdndStatus").data.l[1] & 1)) return false;
        send("XdndDrop", 0, CurrentTime, 0, 0);
        return waitFor("XdndFinished").data.l[1] != 0; // GLFW stores a length there
    }

  private:
    Atom atom(const char* name) { return XInternAtom(display_, name, False); }

    /// The target's middle on the screen: x and y in 16 bits each.
    long middle() {
        XWindowAttributes about;
        XGetWindowAttributes(display_, target_, &about);
        int x = 0, y = 0;
        Window child;
        XTranslateCoordinates(display_, target_, about.root, about.width / 2, about.height / 2, &x,
                              &y, &child);
        return (static_cast<long>(x) << 16) | y;
    }

    void send(const char* message, long one, long two, long three, long four) {
        XEvent event{};
        event.xclient.type = ClientMessage;
        event.xclient.window = target_;
        event.xclient.message_type = atom(message);
        event.xclient.format = 32;
        const long data[] = {static_cast<long>(source_), one, two, three, four};
        std::memcpy(event.xclient.data.l, data, sizeof data);
        XSendEvent(display_, target_, False, NoEventMask, &event);
        XFlush(display_);
    }

    /// Waits for the target's next message of that name, and sends the data meanwhile. Ends the
    /// program after a minute.
    XClientMessageEvent waitFor(const char* message) {
        const auto until = std::chrono::steady_clock::now() + std::chrono::minutes(1);
        while (std::chrono::steady_clock::now() < until) {
            if (!XPending(display_)) {
                std::this_thread::sleep_for(std::chrono::milliseconds(5));
                continue;
            }
            XEvent event;
            XNextEvent(display_, &event);
            if (event.type == SelectionRequest) hand(event.xselectionrequest);
            if (event.type == ClientMessage && event.xclient.message_type == atom(message))
                return event.xclient;
        }
        std::cerr << "The window sends no " << message << ".\n";
        std::exit(1);
    }

    void hand(const XSelectionRequestEvent& request) {
        XChangeProperty(display_, request.requestor, request.property, request.target, 8,
                        PropModeReplace, reinterpret_cast<const unsigned char*>(text_.data()),
                        static_cast<int>(text_.size()));
        XEvent event{};
        event.xselection.type = SelectionNotify;
        event.xselection.requestor = request.requestor;
        event.xselection.selection = request.selection;
        event.xselection.target = request.target;
        event.xselection.property = request.property;
        event.xselection.time = request.time;
        XSendEvent(display_, request.requestor, False, NoEventMask, &event);
        XFlush(display_);
    }

    Display* display_;
    Window target_;
    std::string text_;
    Window source_;
};

} // namespace

int main(int count, char** words) {
    Display* display = count == 3 ? XOpenDisplay(nullptr) : nullptr;
    if (!display) {
        std::cerr << "drop_file WINDOW FILE, with a display\n";
        return 1;
    }
    const std::string file = std::filesystem::absolute(words[2]).string();
    const bool taken = Drag(display, std::strtoul(words[1], nullptr, 0), file).dropIt();
    XCloseDisplay(display);
    return taken ? 0 : 1;
}
