// window OUT.ppm: draws the picture in a GLFW window.
#include "picture.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <exception>
#include <iostream>

namespace {

GLFWwindow* openWindow() {
    if (!glfwInit()) return nullptr;
    glfwWindowHint(GLFW_CLIENT_API, GLFW_OPENGL_ES_API);
    glfwWindowHint(GLFW_CONTEXT_CREATION_API, GLFW_EGL_CONTEXT_API);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 2);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 0);
    glfwWindowHint(GLFW_RESIZABLE, GLFW_FALSE);
    GLFWwindow* window =
        glfwCreateWindow(pictureWidth, pictureHeight, "edgeshade's consumer", nullptr, nullptr);
    if (window) glfwMakeContextCurrent(window);
    return window;
}

} // namespace

int main(int, char** words) {
    GLFWwindow* window = openWindow();
    if (!window) {
        std::cerr << "No window with ES 2.0 can be opened here.\n";
        glfwTerminate();
        return 3;
    }
    int status = 0;
    try {
        drawPicture(
            [](const char* name) { return reinterpret_cast<void*>(glfwGetProcAddress(name)); });
        writePicture(words[1]);
        glfwSwapBuffers(window);
    } catch (const std::exception& error) {
        std::cerr << error.what() << "\n";
        status = 1;
    }
    glfwTerminate();
    return status;
}
